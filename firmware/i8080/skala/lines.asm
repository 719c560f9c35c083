; Hidden lines on the EF9365 board (the paper's algorithm 3.1), as fast as they can be had: DRAW with the visibility
; test, no silhouettes. All other cases go through steps.asm and draw the same.
;
; Between two DRAW commands all state stays in registers: L = xp, B = yp, and H says what is still to be done to the
; masks in the column of the pen, where they are kept as they were before the line came into it:
;   MTP     the top becomes B       (the last point was above)
;   MBP     the bottom becomes B    (below)
;   S0P     nothing                 (hidden, or the column is folded)
;   S1P     nothing: the line came in above and ran down; MT has the new top, OLDM the old one + 1
;   S2P     nothing: the line came in below and ran up; MB has the new bottom, OLDM the old one
; so that MOV M,B folds the column in every case, the last three into a page nobody reads.
;
; Along x a column is entered once: it is tested and folded in one, but for the last. Along y a line within a column
; has parts: P1 outside where it came in, P2 hidden, P3 outside on the other side; each needs one comparison at most.

OLDM:   DB      0

; DRAW from memory's state.
DRAWV:  POP     D
        LXI     H,STEPD
        SHLD    GSTEP+1
        SHLD    FSTEP+1
        CALL    FIRST
        LHLD    PLO
        MOV     A,H
        CMP     L
        LHLD    XYP
        MOV     B,H
        MVI     H,S0P
        JC      VLINE           ; nothing pending
        LDA     PX
        CMP     L
        JNZ     GLINE           ; pending elsewhere: only after TESTDRAW
        CALL    DRAWVP
        JC      DRAWV2
        PUSH    H
        LXI     H,NOPEND
        SHLD    PLO
        POP     H
        JMP     VLINE
DRAWV2: MOV     A,E             ; a line along x leaves the column at once
        SUB     L
        JNC     DRAWV3
        CMA
        INR     A
DRAWV3: MOV     C,A
        MOV     A,D
        SUB     B
        JNC     DRAWV4
        CMA
        INR     A
DRAWV4: CMP     C
        JC      DRAWV5
        JNZ     GLINE
        ORA     A
        JZ      NEXT            ; no length
DRAWV5: CALL    FOLD
        MVI     H,S0P
        JMP     VLINE

; What the pending column is for the fast loops: H as above, or carry when they cannot have it. Keeps DE, L, B.
DRAWVP: MVI     H,MTP
        MOV     A,M
        INR     H
        CMP     M
        RC                      ; unvisited
        LDA     PLO
        CMP     M
        JC      DRAWV1          ; below
        DCR     H
        LDA     PHI
        CMP     M
        MVI     H,S0P
        RZ
        CMC
        RNC
        MVI     H,MTP           ; above: the pen must be at the highest row
        CMP     B
        RZ
        STC
        RET
DRAWV1: CMP     B
        STC
        RNZ
        DCR     H
        LDA     PHI
        CMP     M
        MVI     H,MBP
        RZ
        CMC
        RET

; The chain goes on with something else: A = command.
VSPILL: MOV     C,A
        CALL    SPILL
        MOV     H,B
        SHLD    XYP
        MOV     A,C
        JMP     DISP

; The pending column back into memory, the masks as before it. Keeps BC, DE, L.
SPILL:  MOV     A,H
        CPI     S0P
        RZ
        MOV     A,L
        STA     PX
        MOV     A,B
        STA     PLO
        STA     PHI
        MOV     A,H
        CPI     S1P
        RC
        JNZ     SPILL2
        MVI     H,MTP
        MOV     A,M
        STA     PHI
        LDA     OLDM
        DCR     A
        MOV     M,A
        RET
SPILL2: CPI     S2P
        RNZ
        MVI     H,MBP
        MOV     A,M
        STA     PLO
        LDA     OLDM
        MOV     M,A
        RET

; ---- Along x. RIGHT: 1 to the right; DX, DY: INR or DCR. In: A = u, D = v, E free.
ALONGX  MACRO   RIGHT,DX,DY
        LOCAL   LOOP,TEST,MINOR,SUB1,ABOVE,ABOVE1,EMPTY,EMPTY1,BELOW,LAST,LAST1
        STA     SUB1+1
        MOV     E,A
        IF      RIGHT
        XRA     A
        SUB     E
        JZ      VNEXT           ; no length
        ELSE
        CMA
        STC
        ENDIF
        RAR
        MOV     C,A
        MOV     M,B             ; fold the column of the pen
        MVI     H,MTP
        MOV     A,B
        OUT     GDPY
        DCR     E
        JZ      LAST
LOOP:   MOV     A,C
        ADD     D
        JC      MINOR
        MOV     C,A
        DX      L
        MOV     A,M
        CMP     B
        JC      ABOVE
        INR     H
        MOV     A,B
        CMP     M
        JC      BELOW
        DCR     H
        DCR     E
        JNZ     LOOP
        JMP     LAST
MINOR:
SUB1:   SUI     0
        MOV     C,A
        DY      B
        MOV     A,B
        OUT     GDPY
        DX      L
        MOV     A,M
        CMP     B
        JC      ABOVE
        INR     H
        MOV     A,B
        CMP     M
        JC      BELOW
        DCR     H
        DCR     E
        JNZ     LOOP
        JMP     LAST
EMPTY:  INR     H               ; MT = 0: unvisited when MB = 255
        MOV     A,M
        INR     A
        JNZ     EMPTY1
        MOV     M,B
EMPTY1: DCR     H
        JMP     ABOVE1
BELOW:  MOV     M,B
        DCR     H
        MOV     A,L
        OUT     GDPX
        MVI     A,DOT
        OUT     GDPCMD
        DCR     E
        JNZ     LOOP
        JMP     LAST
ABOVE:  ORA     A
        JZ      EMPTY
ABOVE1: MOV     M,B
        MOV     A,L
        OUT     GDPX
        MVI     A,DOT
        OUT     GDPCMD
        DCR     E
        JNZ     LOOP
LAST:   MOV     A,C             ; the last column is left pending
        ADD     D
        JNC     LAST1
        DY      B
        MOV     A,B
        OUT     GDPY
LAST1:  DX      L
        MOV     A,M
        CMP     B
        JC      VABOVE
        INR     H
        MOV     A,B
        CMP     M
        JC      VBELOW
        MVI     H,S0P
        JMP     VNEXT
        ENDM

; ---- The end of a line along x: its last point is visible.
VABOVE: ORA     A
        JNZ     VBELOW
        INR     H
        MOV     A,M
        DCR     H
        INR     A
        JZ      VFIRST
VBELOW: MOV     A,L
        OUT     GDPX
        MVI     A,DOT
        OUT     GDPCMD

; ---- The next command of the chain.
VNEXT:  DCX     SP
        POP     PSW
        CPI     2
        JNZ     VSPILL
        POP     D
VLINE:  MOV     A,E
        SUB     L
        JC      VLEFT
        MOV     C,A             ; C = u
        MOV     A,D
        SUB     B
        JC      VRDN
        MOV     D,A             ; D = v
        MOV     A,C
        CMP     D
        JC      VRUPY
        ALONGX  1,INR,INR
VRUPY:  MOV     E,D             ; along y: the length is v
        XRA     A
        SUB     E
        RAR
        MOV     D,C
        MOV     C,A
        MVI     A,INRL
        JMP     U

VRDN:   CMA
        INR     A
        MOV     D,A
        MOV     A,C
        CMP     D
        JC      VRDNY
        ALONGX  1,INR,DCR
VRDNY:  MOV     E,D
        XRA     A
        SUB     E
        RAR
        MOV     D,C
        MOV     C,A
        MVI     A,INRL
        JMP     D0

VLEFT:  CMA
        INR     A
        MOV     C,A
        MOV     A,D
        SUB     B
        JC      VLDN
        MOV     D,A
        MOV     A,C
        CMP     D
        JC      VLUPY
        ALONGX  0,DCR,INR
VLUPY:  MOV     A,D
        MOV     E,D
        MOV     D,C
        CMA
        STC
        RAR
        MOV     C,A
        MVI     A,DCRL
        JMP     U

VLDN:   CMA
        INR     A
        MOV     D,A
        MOV     A,C
        CMP     D
        JC      VLDNY
        ALONGX  0,DCR,DCR
VLDNY:  MOV     A,D
        MOV     E,D
        MOV     D,C
        CMA
        STC
        RAR
        MOV     C,A
        MVI     A,DCRL
        JMP     D0

; The first point ever in a column: both masks wait for it, in memory.
VFIRST: MOV     A,L
        OUT     GDPX
        MVI     A,DOT
        OUT     GDPCMD
        MOV     H,B
        SHLD    XYP
        MOV     A,L
        STA     PX
        MOV     A,B
        STA     PLO
        STA     PHI
        JMP     NEXT

; ---- Along y, upwards. In: A = instruction of a step along x, C = error, D = u, E = v.
U:      STA     UDX
        MOV     A,E
        STA     USUB1+1
        MOV     A,L
        OUT     GDPX
        MOV     A,H
        CPI     S0P
        JZ      UFIRST1
        CPI     MTP
        JZ      UP3LOOP
        CPI     MBP
        JZ      UBELOW
        CPI     S2P
        JZ      UP1GO
UTURN:  CALL    SPILL           ; came in above, ran down, and now turns: step by step
        MVI     A,INRB
        STA     GMAJ
        LDA     UDX
        STA     GMIN
        LDA     USUB1+1
        STA     GSUB+1
        CALL    GLOOP
        JMP     NEXT
UBELOW: MOV     A,M             ; the point before becomes the new bottom, the old one is kept beside
        INR     A
        JZ      UTURN            ; unvisited but for row 0
        DCR     A
        STA     UOLD+1
        MOV     M,B
        JMP     UP1LOOP
UP1GO:  MVI     H,MTP
        LDA     OLDM
        STA     UOLD+1
        CMP     B
        JC      UP2GO
        JZ      UP2GO

UP1LOOP:MOV     A,C             ; P1: below the old bottom
        ADD     D
        JC      UNEW
        MOV     C,A
        INR     B
        MOV     A,B
UOLD:   CPI     0
        JNC     UP1HID
UP1OUT: OUT     GDPY
        MVI     A,DOT
        OUT     GDPCMD
        DCR     E
        JNZ     UP1LOOP
UP1END: LDA     UOLD+1
        STA     OLDM
        MVI     H,S2P
        JMP     VNEXT
UP1HID: MVI     H,MTP
        DCR     E
        JZ      UP1END
UP2GO:  MOV     A,C             ; P2 after P1
        ADD     D
        JC      UNEW
        MOV     C,A
        INR     B
        MOV     A,M
        CMP     B
        JC      UCROSS
        DCR     E
        JNZ     UP2GO
        JMP     UP1END
UCROSS: MOV     A,L             ; through both masks in one column: step by step
        STA     PX
        MOV     A,B
        DCR     A
        STA     PHI
        INR     H
        MOV     A,M
        STA     PLO
        LDA     UOLD+1
        MOV     M,A
USLOW:  MVI     A,INRB
        STA     GMAJ
        LDA     UDX
        STA     GMIN
        LDA     USUB1+1
        STA     GSUB+1
        CALL    GSTEP
        JMP     NEXT

UP3NEW: MOV     M,B
UNEW:
USUB1:  SUI     0               ; a new column
        MOV     C,A
        INR     B
UDX:   INR     L               ; or DCR L
        MOV     A,L
        OUT     GDPX
UCOLUMN:MVI     H,MTP
        MOV     A,M
        CMP     B
        JC      UABOVE
        INR     H
        MOV     A,B
        CMP     M
        JC      UBELOW1
        DCR     H
        DCR     E
        JNZ     UP2LOOP
        MVI     H,S0P
        JMP     VNEXT
UP2LOOP:MOV     A,C             ; P2: hidden
        ADD     D
        JC      UNEW
        MOV     C,A
        INR     B
        MOV     A,M
        CMP     B
        JC      UP3DOT
        DCR     E
        JNZ     UP2LOOP
        MVI     H,S0P
        JMP     VNEXT
UFIRST1:MOV     A,C
        ADD     D
        JC      UNEW
        MOV     C,A
        INR     B
        JMP     UCOLUMN
UBELOW1:MOV     A,M
        INR     A
        JNZ     UBELOW2
        DCR     H
        MOV     A,M
        INR     H
        ORA     A
        JZ      USLOW            ; unvisited
UBELOW2:MOV     A,M
        STA     UOLD+1
        MOV     M,B
        MOV     A,B
        JMP     UP1OUT
UABOVE: ORA     A
        JNZ     UP3DOT
        INR     H
        MOV     A,M
        DCR     H
        INR     A
        JZ      USLOW            ; unvisited
UP3DOT: MOV     A,B
        OUT     GDPY
        MVI     A,DOT
        OUT     GDPCMD
        DCR     E
        JZ      VNEXT
UP3LOOP:MOV     A,C             ; P3: above
        ADD     D
        JC      UP3NEW
        MOV     C,A
        INR     B
        MOV     A,B
        OUT     GDPY
        MVI     A,DOT
        OUT     GDPCMD
        DCR     E
        JNZ     UP3LOOP
        JMP     VNEXT

; ---- Along y, downwards: the mirror image. H = MBP where upwards it is MTP.
D0:     STA     DDX
        MOV     A,E
        STA     DSUB1+1
        MOV     A,L
        OUT     GDPX
        MOV     A,H
        CPI     S0P
        JZ      DFIRST1
        CPI     MBP
        JZ      DP3LOOP
        CPI     MTP
        JZ      DABOVE
        CPI     S1P
        JZ      DP1GO
        CALL    SPILL           ; came in below, ran up, and now turns
        MVI     A,DCRB
        STA     GMAJ
        LDA     DDX
        STA     GMIN
        LDA     DSUB1+1
        STA     GSUB+1
        CALL    GLOOP
        JMP     NEXT
DABOVE: MOV     A,M
        INR     A
        STA     DOLD+1           ; the old top + 1: visible is what is not below that
        MOV     M,B
        JMP     DP1LOOP
DP1GO:  MVI     H,MBP
        LDA     OLDM
        STA     DOLD+1
        CMP     B
        JC      DP1LOOP
        JNZ     DP2GO

DP1LOOP:MOV     A,C             ; P1: above the old top
        ADD     D
        JC      DNEW
        MOV     C,A
        DCR     B
        MOV     A,B
DOLD:   CPI     0
        JC      DP1HID
DP1OUT: OUT     GDPY
        MVI     A,DOT
        OUT     GDPCMD
        DCR     E
        JNZ     DP1LOOP
DP1END: LDA     DOLD+1
        STA     OLDM
        MVI     H,S1P
        JMP     VNEXT
DP1HID: MVI     H,MBP
        DCR     E
        JZ      DP1END
DP2GO:  MOV     A,C             ; P2 after P1
        ADD     D
        JC      DNEW
        MOV     C,A
        DCR     B
        MOV     A,B
        CMP     M
        JC      DCROSS
        DCR     E
        JNZ     DP2GO
        JMP     DP1END
DCROSS: MOV     A,L             ; through both masks in one column
        STA     PX
        MOV     A,B
        INR     A
        STA     PLO
        DCR     H
        MOV     A,M
        STA     PHI
        LDA     DOLD+1
        DCR     A
        MOV     M,A
DSLOW:  MVI     A,DCRB
        STA     GMAJ
        LDA     DDX
        STA     GMIN
        LDA     DSUB1+1
        STA     GSUB+1
        CALL    GSTEP
        JMP     NEXT

DP3NEW: MOV     M,B
DNEW:
DSUB1:  SUI     0               ; a new column
        MOV     C,A
        DCR     B
DDX:   INR     L               ; or DCR L
        MOV     A,L
        OUT     GDPX
DCOLUMN:MVI     H,MBP
        MOV     A,B
        CMP     M
        JC      DBELOW
        DCR     H
        MOV     A,M
        CMP     B
        JC      DABOVE1
        INR     H
        DCR     E
        JNZ     DP2LOOP
        MVI     H,S0P
        JMP     VNEXT
DP2LOOP:MOV     A,C             ; P2: hidden
        ADD     D
        JC      DNEW
        MOV     C,A
        DCR     B
        MOV     A,B
        CMP     M
        JC      DP3DOT
        DCR     E
        JNZ     DP2LOOP
        MVI     H,S0P
        JMP     VNEXT
DFIRST1:MOV     A,C
        ADD     D
        JC      DNEW
        MOV     C,A
        DCR     B
        JMP     DCOLUMN
DABOVE1:ORA     A
        JNZ     DABOVE2
        INR     H
        MOV     A,M
        DCR     H
        INR     A
        JZ      DSLOW            ; unvisited
DABOVE2:MOV     A,M
        INR     A
        STA     DOLD+1
        MOV     M,B
        MOV     A,B
        JMP     DP1OUT
DBELOW: MOV     A,M
        INR     A
        JNZ     DP3DOT
        DCR     H
        MOV     A,M
        INR     H
        ORA     A
        JZ      DSLOW            ; unvisited
DP3DOT: MOV     A,B
        OUT     GDPY
        MVI     A,DOT
        OUT     GDPCMD
        DCR     E
        JZ      VNEXT
DP3LOOP:MOV     A,C             ; P3: below
        ADD     D
        JC      DP3NEW
        MOV     C,A
        DCR     B
        MOV     A,B
        OUT     GDPY
        MVI     A,DOT
        OUT     GDPCMD
        DCR     E
        JNZ     DP3LOOP
        JMP     VNEXT
