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

; Another command follows in the chain: A = command.
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

; ---- Along x. RIGHT: 1 to the right; DX: INR or DCR; DY1, DY2 label the two steps along y, which are put in. In: A = the
; instruction of a step along y, C = u, D = v, E free.
ALONGX  MACRO   RIGHT,DX,DY1,DY2
        LOCAL   LOOP,TEST,MINOR,SUB1,ABOVE,ABOVE1,EMPTY,EMPTY1,BELOW,LAST,LAST1
        STA     DY1
        STA     DY2
        MOV     A,C
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
DY1:    INR     B
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
DY2:    INR     B
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
        MVI     A,INRB
VRIGHT: ALONGX  1,INR,VRDY1,VRDY2
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
        MVI     A,DCRB
        JMP     VRIGHT
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
        MVI     A,INRB
VBACK:  ALONGX  0,DCR,VLDY1,VLDY2
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
        MVI     A,DCRB
        JMP     VBACK
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
