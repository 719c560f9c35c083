; Antialiasing: how much of a dot a face covers, from the sides of its stripes. Source: SPECIFICATION.md, section 8.
;
; A list of a face has pairs: a column, and the layers (bits 0 to 3) that change there. A list of the silhouette has three bytes:
; a column, the layers covered from there on, and the sum of the levels of the faces that cover them; where all are covered the
; sum is 0. Columns ascend; 255 ends a list. Before the first column nothing is covered.

ALPHA:  DB      0,0,0           ; how far the outer and the inner two layers are from the side, in 1/65536 dot
BETA:   DB      0,0,0
COLS:   DB      0,0,0,0,255     ; where a side enters the layers
SMASK:  DB      0               ; at hand: the silhouette's layers and sum, the face's layers
SSUM:   DB      0
FMASK:  DB      0
OSUM:   DB      0               ; last in the list that is made
OMASK:  DB      0
OUTP:   DW      0
LEVEL:  DB      0
; CONTR is level times layers, for each set of layers, in one page.
CONTR   EQU     CUTS+80H

; ALPHA and BETA of a side with the step B:DE from line to line. Keeps B, D, E.
SPREAD: PUSH    B
        PUSH    D
        MVI     L,3
SPREA1: ORA     A               ; carry off
        MOV     A,B
        RAR
        MOV     B,A
        MOV     A,D
        RAR
        MOV     D,A
        MOV     A,E
        RAR
        MOV     E,A
        DCR     L
        JNZ     SPREA1
        XCHG                    ; B:HL = an eighth of it
        MOV     A,B
        ORA     A
        JNZ     SPREA4
        MOV     A,H
        CPI     40H
        JNC     SPREA4
        CPI     20H             ; below 1/4 dot
        LXI     D,2000H
        JC      SPREA2
        MOV     D,H
        MOV     E,L
SPREA2: XCHG
        SHLD    BETA
        XCHG
        DAD     H
        LXI     D,4000H
        DAD     D
        MOV     A,H
        CPI     60H
        JNC     SPREA3
        LXI     H,6000H
SPREA3: SHLD    ALPHA
        XRA     A
        STA     BETA+2
        JMP     SPREA5
SPREA4: SHLD    BETA
        MOV     D,H
        MOV     E,L
        MOV     A,B
        STA     BETA+2
        DAD     H               ; three times B:HL
        ADC     B
        DAD     D
        ADC     B
        SHLD    ALPHA
SPREA5: STA     ALPHA+2
        POP     D
        POP     B
        RET

; The side at C:HL into the list at SLOT: a toggle, or the four layers.
SIDE4:  LDA     LAYERS
        ORA     A
        JNZ     SIDE41
        MOV     B,C
        LHLD    SLOT
        JMP     INSERT
SIDE41: LXI     D,ALPHA
        CALL    BELOW
        STA     COLS
        LXI     D,BETA
        CALL    BELOW
        STA     COLS+1
        LXI     D,BETA
        CALL    ABOVE
        STA     COLS+2
        LXI     D,ALPHA
        CALL    ABOVE
        STA     COLS+3
        LXI     H,COLS
        LXI     B,1             ; B: layers that change in this column, C: the next
SIDE42: MOV     A,C
        ORA     B
        MOV     B,A
        MOV     A,C
        ADD     A
        MOV     C,A
        MOV     A,M
        INX     H
        CPI     255
        RZ
        CMP     M
        JZ      SIDE42
        PUSH    H
        PUSH    B
        CALL    CHANGE
        POP     B
        POP     H
        MVI     B,0
        MOV     A,C
        CPI     16
        JNZ     SIDE42
        RET

; A = the column of C:HL less (plus) the three bytes at DE.
BELOW:  LDAX    D
        MOV     B,A
        MOV     A,L
        SUB     B
        INX     D
        LDAX    D
        MOV     B,A
        MOV     A,H
        SBB     B
        INX     D
        LDAX    D
        MOV     B,A
        MOV     A,C
        SBB     B
        RNC
        XRA     A
        RET
ABOVE:  LDAX    D
        ADD     L
        INX     D
        LDAX    D
        ADC     H
        INX     D
        LDAX    D
        ADC     C
        RNC
        MVI     A,255
        RET

; Layers B change in column A of the list at SLOT.
CHANGE: LHLD    SLOT
CHANG1: CMP     M
        JZ      CHANG3
        JC      CHANG2
        INX     H
        INX     H
        JMP     CHANG1
CHANG2: MOV     C,M             ; before the first greater one
        MOV     M,A
        INX     H
        MOV     A,M
        MOV     M,B
        MOV     B,A
        INX     H
        MOV     A,C
        CPI     255
        JNZ     CHANG2
        XCHG
        LHLD    SLOT
        MOV     A,E
        SUB     L
        CPI     48
        JNC     OVERF
        XCHG
        MVI     M,255
        RET
CHANG3: INX     H               ; it is there
        MOV     A,M
        XRA     B
        MOV     M,A
        RNZ
        MOV     D,H             ; nothing changes any more: out
        MOV     E,L
        DCX     D
        INX     H
CHANG4: MOV     A,M
        STAX    D
        INX     H
        INX     D
        INR     A
        JNZ     CHANG4
        RET

; The list at HL less that at DE, to UBUF.
LESSL:  XRA     A
        STA     FMASK
        STA     SMASK
        STA     OMASK
        PUSH    H
        LXI     H,UBUF
        SHLD    OUTP
        POP     H
LESSL1: LDAX    D
        CMP     M
        JC      LESSL2
        MOV     A,M
LESSL2: MOV     C,A             ; the next column
        CMP     M
        JNZ     LESSL3
        INR     A
        JZ      LESSL5
        INX     H
        LDA     FMASK
        XRA     M
        STA     FMASK
        INX     H
LESSL3: LDAX    D
        CMP     C
        JNZ     LESSL4
        INX     D
        LDAX    D
        INX     D
        MOV     B,A
        LDA     SMASK
        XRA     B
        STA     SMASK
LESSL4: LDA     SMASK
        CMA
        MOV     B,A
        LDA     FMASK
        ANA     B
        MOV     B,A
        LDA     OMASK
        XRA     B               ; what changes
        JZ      LESSL1
        PUSH    H
        LHLD    OUTP
        MOV     M,C
        INX     H
        MOV     M,A
        INX     H
        SHLD    OUTP
        POP     H
        MOV     A,B
        STA     OMASK
        JMP     LESSL1
LESSL5: LHLD    OUTP
        MVI     M,255
        RET

; The face at FS over the silhouette.
LAY:    LDA     FACED
        CALL    RECOF
        INX     H
        INX     H
        MOV     A,M
        STA     LEVEL
        LXI     H,CONTR
        MVI     M,0
        INX     H
        MVI     B,1
LAY1:   LXI     D,CONTR
        MOV     C,B
LAY2:   LDAX    D
        INX     D
        PUSH    H
        LXI     H,LEVEL
        ADD     M
        POP     H
        MOV     M,A
        INX     H
        DCR     C
        JNZ     LAY2
        MOV     A,B
        ADD     A
        MOV     B,A
        CPI     16
        JNZ     LAY1
        LDA     YLO
        STA     LINE
        MVI     D,FS SHR 8
        CALL    SLOT48
        SHLD    FPTR
        LDA     YLO
        MVI     D,SS SHR 8
        CALL    SLOT96
        SHLD    SPTR
LAY3:   LDA     LINE
        LXI     H,YHI
        CMP     M
        RZ
        LHLD    SPTR
        XCHG
        LHLD    FPTR
        CALL    OVER
        LHLD    SPTR
        MVI     B,96
        CALL    TAKEU
DRAW8:  LHLD    FPTR
        LXI     D,48
        DAD     D
        SHLD    FPTR
        LHLD    SPTR
        LXI     D,96
        DAD     D
        SHLD    SPTR
        LXI     H,LINE
        INR     M
        JMP     LAY3

; A line of the face, at HL, and the silhouette's, at DE: dots that are complete with this face on the board, the new
; silhouette at UBUF.
OVER:   XRA     A
        STA     FMASK
        STA     SMASK
        STA     SSUM
        STA     OMASK
        STA     OSUM
        MOV     B,A
        PUSH    H
        LXI     H,UBUF
        SHLD    OUTP
        POP     H
OVER1:  LDAX    D
        CMP     M
        JC      OVER2
        MOV     A,M
OVER2:  MOV     C,A             ; the next column
        CMP     B
        CNZ     PART
        MOV     B,C
        MOV     A,M
        CMP     C
        JNZ     OVER3
        INR     A
        JZ      OVER9
        INX     H
        LDA     FMASK
        XRA     M
        STA     FMASK
        INX     H
OVER3:  LDAX    D
        CMP     C
        JNZ     OVER1
        INX     D
        LDAX    D
        STA     SMASK
        INX     D
        LDAX    D
        STA     SSUM
        INX     D
        JMP     OVER1
OVER9:  LHLD    OUTP
        MVI     M,255
        RET

; The dots from column B to before C, in which nothing changes. Keeps BC, DE, HL.
PART:   PUSH    H
        PUSH    D
        LDA     SMASK
        MOV     E,A
        CMA
        MOV     D,A
        LDA     FMASK
        ANA     D               ; the layers that the face has first
        MOV     D,A
        LDA     SSUM
        JZ      PART1
        MOV     L,D
        MVI     H,0
        PUSH    D
        LXI     D,CONTR
        DAD     D
        POP     D
        ADD     M
        MOV     L,A
        MOV     A,E
        ORA     D
        MOV     E,A
        CPI     15
        MOV     A,L
        JNZ     PART1
        CALL    DOTS
        XRA     A
PART1:  LXI     H,OSUM
        CMP     M
        JNZ     PART2
        INX     H
        MOV     D,A
        MOV     A,E
        CMP     M
        MOV     A,D
        DCX     H
        JZ      PART3
PART2:  MOV     M,A
        INX     H
        MOV     M,E
        LHLD    OUTP
        MOV     M,B
        INX     H
        MOV     M,E
        INX     H
        MOV     M,A
        INX     H
        SHLD    OUTP
PART3:  POP     D
        POP     H
        RET

; The dots from column B to before C on the board, with a quarter of A as their level. Keeps BC, E, HL.
DOTS:   ADI     2
        RRC
        RRC
        ANI     7
        RZ
        MOV     D,A
        CALL    GDPWT
        MOV     A,D
        OUT     GDPCOL
        MOV     A,B
        OUT     GDPX
        LDA     LINE
        OUT     GDPY
        MOV     A,C
        SUB     B
        DCR     A
        OUT     GDPDX
        MVI     A,EAST
        OUT     GDPCMD
        RET

; After the last face: the dots that no face completed, before the background.
REST:   XRA     A
        STA     LINE
        LXI     H,SS
REST1:  PUSH    H
REST2:  MOV     A,M
        CPI     255
        JZ      REST3
        MOV     B,A
        INX     H
        MOV     A,M
        INX     H
        MOV     D,M
        INX     H
        ORA     A
        JZ      REST2
        CPI     15
        JZ      REST2
        MOV     C,M
        MOV     A,D
        CALL    DOTS
        JMP     REST2
REST3:  POP     H
        LXI     D,96
        DAD     D
        LDA     LINE
        INR     A
        STA     LINE
        CPI     255
        JNZ     REST1
        RET
