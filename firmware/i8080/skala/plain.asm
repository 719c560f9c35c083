; Lines on the EF9365 board without the visibility test: the same loops with the masks left out, for the comparison.
; Between two DRAW commands L = xp, B = yp.

; DRAW and TESTDRAW from memory's state.
DRAWP:  POP     D
        LXI     H,PLOT
        SHLD    FSTEP+1
        CALL    FIRST
        LHLD    XYP
        MOV     B,H
        JMP     PLINE

; Another command follows in the chain: A = command.
PSPILL: MOV     H,B
        SHLD    XYP
        JMP     DISP

; ---- Along x; DY labels the step along y, which is put in. In: A = its instruction, C = u, D = v.
PLAINX  MACRO   RIGHT,DX,DY
        LOCAL   LOOP,MINOR,SUB1
        STA     DY
        MOV     A,C
        STA     SUB1+1
        MOV     E,A
        IF      RIGHT
        XRA     A
        SUB     E
        JZ      PNEXT           ; no length
        ELSE
        CMA
        STC
        ENDIF
        RAR
        MOV     C,A
        MOV     A,B
        OUT     GDPY
        MVI     H,DOT
LOOP:   MOV     A,C
        ADD     D
        JC      MINOR
        MOV     C,A
        DX      L
        MOV     A,L
        OUT     GDPX
        MOV     A,H
        OUT     GDPCMD
        DCR     E
        JNZ     LOOP
        JMP     PNEXT
MINOR:
SUB1:   SUI     0
        MOV     C,A
DY:     INR     B
        MOV     A,B
        OUT     GDPY
        DX      L
        MOV     A,L
        OUT     GDPX
        MOV     A,H
        OUT     GDPCMD
        DCR     E
        JNZ     LOOP
        JMP     PNEXT
        ENDM

PNEXT:  DCX     SP
        POP     PSW
        CPI     2
        JNZ     PSPILL
        POP     D
PLINE:  MOV     A,E
        SUB     L
        JC      PLEFT
        MOV     C,A
        MOV     A,D
        SUB     B
        JC      PRDN
        MOV     D,A
        MOV     A,C
        CMP     D
        JC      PRUPY
        MVI     A,INRB
PRIGHT: PLAINX  1,INR,PRDY
PRUPY:  MVI     H,INRB
        JMP     PRY

PRDN:   CMA
        INR     A
        MOV     D,A
        MOV     A,C
        CMP     D
        JC      PRDNY
        MVI     A,DCRB
        JMP     PRIGHT
PRDNY:  MVI     H,DCRB
PRY:    MOV     E,D
        XRA     A
        SUB     E
        RAR
        MOV     D,C
        MOV     C,A
        MVI     A,INRL
        JMP     PLAINY

PLEFT:  CMA
        INR     A
        MOV     C,A
        MOV     A,D
        SUB     B
        JC      PLDN
        MOV     D,A
        MOV     A,C
        CMP     D
        JC      PLUPY
        MVI     A,INRB
PBACK:  PLAINX  0,DCR,PLDY
PLUPY:  MVI     H,INRB
        JMP     PLY

PLDN:   CMA
        INR     A
        MOV     D,A
        MOV     A,C
        CMP     D
        JC      PLDNY
        MVI     A,DCRB
        JMP     PBACK
PLDNY:  MVI     H,DCRB
PLY:    MOV     A,D
        MOV     E,D
        MOV     D,C
        CMA
        STC
        RAR
        MOV     C,A
        MVI     A,DCRL


; ---- Along y. In: A, H = instructions of a step along x and along y, C = error, D = u, E = v.
PLAINY: STA     PLNYX
        MOV     A,H
        STA     PLNYB1
        STA     PLNYB2
        MOV     A,E
        STA     PLNYS+1
        MOV     A,L
        OUT     GDPX
        MVI     H,DOT
PLNY1:  MOV     A,C
        ADD     D
        JC      PLNY2
        MOV     C,A
PLNYB1: INR     B
        MOV     A,B
        OUT     GDPY
        MOV     A,H
        OUT     GDPCMD
        DCR     E
        JNZ     PLNY1
        JMP     PNEXT
PLNY2:
PLNYS:  SUI     0
        MOV     C,A
PLNYX:  INR     L
        MOV     A,L
        OUT     GDPX
PLNYB2: INR     B
        MOV     A,B
        OUT     GDPY
        MOV     A,H
        OUT     GDPCMD
        DCR     E
        JNZ     PLNY1
        JMP     PNEXT
