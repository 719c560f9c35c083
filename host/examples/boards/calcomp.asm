; CalComp 565: an octagon, one command for a step. Look at the time: 300 steps a second.
PORT    EQU     60H
UP      EQU     8
DOWN    EQU     9

        ORG     0100H
        LXI     SP,8000H
        MVI     A,DOWN
        CALL    ORDER
        MVI     C,0             ; direction: 0 is +y, then clockwise
SIDE:   MVI     B,60            ; 60 steps of 0.254 mm
STEP:   MOV     A,C
        CALL    ORDER
        DCR     B
        JNZ     STEP
        INR     C
        MOV     A,C
        CPI     8
        JNZ     SIDE
        MVI     A,UP
        CALL    ORDER
        HLT

ORDER:  PUSH    PSW
WAIT:   IN      PORT
        RRC                     ; bit 0, BUSY, into the carry
        JC      WAIT
        POP     PSW
        OUT     PORT
        RET
        END
