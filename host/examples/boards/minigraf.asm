; Minigraf 0507: a zigzag of 8 lines. Look at PAUSE: the plotter has no status, the program must give its motors time.
PORT    EQU     0F0H

        ORG     0100H
        LXI     SP,8000H
        LXI     D,0             ; D the phase of the X motor, E that of the Y motor
        MVI     C,8
LINE:   MVI     B,100
STEP:   INR     D               ; X one step forward
        MOV     A,C
        RRC
        JC      BACK
        INR     E               ; Y forward in even lines,
        JMP     PUT
BACK:   DCR     E               ; back in odd ones
PUT:    MOV     A,E
        ANI     7
        RLC
        RLC
        RLC
        MOV     L,A
        MOV     A,D
        ANI     7
        ORA     L
        ORI     80H             ; pen down
        OUT     PORT
        CALL    PAUSE
        DCR     B
        JNZ     STEP
        DCR     C
        JNZ     LINE
        ANI     7FH             ; pen up
        OUT     PORT
        HLT

PAUSE:  PUSH    PSW
        LXI     H,500           ; 500 rounds of 24 T-states: 4 ms at 3 MHz
MORE:   DCX     H
        MOV     A,H
        ORA     L
        JNZ     MORE
        POP     PSW
        RET
        END
