; Contours: silhouettes where the surface folds, and the outer outline.

; FOLD when silhouettes are kept: as FOLDK, and LT and HB hold the far end of what last raised a top or lowered a bottom -
; one row less and one more, and 0 and 255 for none, so that one comparison tells whether a margin lies wholly beyond that
; end: there the surface has turned away.
FOLDC:  MVI     H,MTP
        MOV     A,M
        CMP     B
        JC      FOLDC4          ; above
        MVI     H,LTP
        MOV     A,B
        CMP     M
        JC      FOLDC1
FOLDC2: MVI     H,MBP
        MOV     A,C
        CMP     M
        JC      FOLDC6          ; below
        MVI     H,HBP
        MOV     A,M
        CMP     C
        RNC
        MVI     M,255           ; wholly above what lowered the bottom
        MOV     A,L
        STA     PX
        JMP     FBOT
FOLDC1: MVI     M,0             ; wholly below what raised the top
        MOV     A,L
        STA     PX
        CALL    FTOP
        JMP     FOLDC2
FOLDC4: ORA     A
        JNZ     FOLDC5
        INR     H
        MOV     A,M
        DCR     H
        INR     A
        JZ      FOLDNW          ; unvisited
FOLDC5: MOV     M,B
        MVI     H,LTP
        MOV     A,C
        SUI     1
        ACI     0
        MOV     M,A
        JMP     FOLDC2
FOLDC6: MOV     A,M
        MOV     M,C
        INR     A
        JNZ     FOLDC7
        DCR     H
        MOV     A,M
        ORA     A
        RZ                      ; unvisited, row 0
FOLDC7: MVI     H,HBP
        MOV     A,B
        ADI     1
        SBI     0
        MOV     M,A
        RET

; Fold lines in column L: from the mask to the lower (at the bottom the higher) of its neighbours' masks. Keep L, BC, DE.
FTOP:   CALL    FWANTD
        RZ
        PUSH    B
        PUSH    D
        LXI     D,255           ; D: not 0 when a neighbour is visited; E: the least
        CALL    FLEFT
        CNZ     FLEAST
        CALL    FRIGHT
        CNZ     FLEAST
        LHLD    PX
        MOV     B,M
FTOP1:  CALL    PLOT
        MOV     A,D
        ORA     A
        JZ      FOLDED
        MOV     A,B
        SUI     1
        JC      FOLDED
        CMP     E
        JC      FOLDED
        JZ      FOLDED
        DCR     B
        JMP     FTOP1
FLEAST: MVI     D,1
        MOV     A,M
        CMP     E
        RNC
        MOV     E,A
        RET

FBOT:   CALL    FWANTD
        RZ
        PUSH    B
        PUSH    D
        LXI     D,0             ; E: the greatest
        CALL    FLEFT
        CNZ     FMOST
        CALL    FRIGHT
        CNZ     FMOST
        LHLD    PX
        MVI     H,MBP
        MOV     B,M
FBOT1:  CALL    PLOT
        MOV     A,D
        ORA     A
        JZ      FOLDED
        MOV     A,B
        INR     A
        JZ      FOLDED
        CMP     E
        JNC     FOLDED
        INR     B
        JMP     FBOT1
FMOST:  MVI     D,1
        INR     H
        MOV     A,M
        CMP     E
        RC
        MOV     E,A
        RET

; The end of either: back to colour c.
FOLDED: LDA     COLR
        CALL    INK
        POP     D
        POP     B
        RET

; Z when folds are not drawn: without a colour, and on plotters, where they would be short runs. Else sets the ink.
FWANTD: LDA     DEV
        CPI     2
        JNC     FWANT1
        LDA     SIL
        ORA     A
        RZ
        JMP     INK
FWANT1: XRA     A
        RET

; The column to the left or right of the pending one: HL = its top, NZ when it is on the screen and visited.
FLEFT:  LHLD    PX
        MOV     A,L
        DCR     L
        JMP     FSIDE
FRIGHT: LHLD    PX
        INR     L
        MOV     A,L
FSIDE:  ORA     A
        RZ
        MOV     A,M
        INR     H
        CMP     M
        DCR     H
        JC      FWANT1
        INR     H               ; not zero
        DCR     H
        RET

; OUTLINE: tops from left to right, bottoms back, for each run of visited columns.
OUTX:   DB      0               ; column at hand
OUTA:   DB      0               ; first column of the run

OUTLIN: LDA     VIS
        ORA     A
        JZ      NEXT            ; without visibility no column is visited
        CALL    FOLD
        LXI     H,PLOT
        SHLD    GSTEP+1
        SHLD    FSTEP+1
        XRA     A
OUTL1:  STA     OUTX
        CALL    VISITD
        JC      OUTL4
        LDA     OUTX
        STA     OUTA
        CALL    OUTTOP
        CALL    MOVET1          ; wherever the pen is
OUTL2:  CALL    OUTTOP
        CALL    LINETO
        LXI     H,OUTX
        INR     M
        JZ      OUTL3
        MOV     A,M
        CALL    VISITD
        JNC     OUTL2
OUTL3:  LDA     OUTX            ; the run is over: back along the bottoms
        PUSH    PSW
        MOV     C,A
OUTL5:  DCR     C
        MOV     A,C
        STA     OUTX
        MOV     L,A
        MOV     E,A
        MVI     H,MBP
        MOV     D,M
        CALL    LINETO
        LDA     OUTX
        MOV     C,A
        LDA     OUTA
        CMP     C
        JNZ     OUTL5
        CALL    OUTTOP          ; and closed
        CALL    LINETO
        POP     PSW
        ORA     A
        JZ      NEXT            ; the run ended at the right border
        STA     OUTX
OUTL4:  LDA     OUTX
        INR     A
        JNZ     OUTL1
        JMP     NEXT

; Column A: carry when unvisited.
VISITD: MOV     L,A
        MVI     H,MTP
        MOV     A,M
        INR     H
        CMP     M
        RET

OUTTOP: LDA     OUTX
        MOV     L,A
        MOV     E,A
        MVI     H,MTP
        MOV     D,M
        RET

; DRAW to E = x, D = y with the engine's step.
LINETO: CALL    FIRST
        CALL    GSET
        RZ
        JMP     GLOOP
