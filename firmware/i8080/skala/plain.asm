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

; ---- Along x. In: A = u, D = v.
PLAINX  MACRO   RIGHT,DX,DY
        LOCAL   LOOP,MINOR,SUB1
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
        DY      B
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

; ---- Along y. In: A = C = u, D = v.
PLAINY  MACRO   RIGHT,DX,DY
        LOCAL   LOOP,MINOR,SUB1
        MOV     A,D
        STA     SUB1+1
        MOV     E,A
        MOV     D,C
        IF      RIGHT
        XRA     A
        SUB     E
        ELSE
        CMA
        STC
        ENDIF
        RAR
        MOV     C,A
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
        DX      L
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
        PLAINX  1,INR,INR
PRUPY:  PLAINY  1,INR,INR

PRDN:   CMA
        INR     A
        MOV     D,A
        MOV     A,C
        CMP     D
        JC      PRDNY
        PLAINX  1,INR,DCR
PRDNY:  PLAINY  1,INR,DCR

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
        PLAINX  0,DCR,INR
PLUPY:  PLAINY  0,DCR,INR

PLDN:   CMA
        INR     A
        MOV     D,A
        MOV     A,C
        CMP     D
        JC      PLDNY
        PLAINX  0,DCR,DCR
PLDNY:  PLAINY  0,DCR,DCR
