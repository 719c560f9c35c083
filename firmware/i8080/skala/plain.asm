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

; The chain goes on with something else: A = command.
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

; ---- Along y. In: A = instruction of a step along x, C = error, D = u, E = v.
PLAINY  MACRO   DY
        LOCAL   LOOP,MINOR,SUB1,DX1
        STA     DX1
        MOV     A,E
        STA     SUB1+1
        MOV     A,L
        OUT     GDPX
        MVI     H,DOT
LOOP:   MOV     A,C
        ADD     D
        JC      MINOR
        MOV     C,A
        DY      B
        MOV     A,B
        OUT     GDPY
        MOV     A,H
        OUT     GDPCMD
        DCR     E
        JNZ     LOOP
        JMP     PNEXT
MINOR:
SUB1:   SUI     0
        MOV     C,A
DX1:    INR     L               ; or DCR L
        MOV     A,L
        OUT     GDPX
        DY      B
        MOV     A,B
        OUT     GDPY
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
PRUPY:  MOV     E,D
        XRA     A
        SUB     E
        RAR
        MOV     D,C
        MOV     C,A
        MVI     A,INRL
        JMP     PUP

PRDN:   CMA
        INR     A
        MOV     D,A
        MOV     A,C
        CMP     D
        JC      PRDNY
        MVI     A,DCRB
        JMP     PRIGHT
PRDNY:  MOV     E,D
        XRA     A
        SUB     E
        RAR
        MOV     D,C
        MOV     C,A
        MVI     A,INRL
        JMP     PDOWN

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
PLUPY:  MOV     A,D
        MOV     E,D
        MOV     D,C
        CMA
        STC
        RAR
        MOV     C,A
        MVI     A,DCRL
        JMP     PUP

PLDN:   CMA
        INR     A
        MOV     D,A
        MOV     A,C
        CMP     D
        JC      PLDNY
        MVI     A,DCRB
        JMP     PBACK
PLDNY:  MOV     A,D
        MOV     E,D
        MOV     D,C
        CMA
        STC
        RAR
        MOV     C,A
        MVI     A,DCRL
        JMP     PDOWN

PUP:    PLAINY  INR
PDOWN:  PLAINY  DCR
