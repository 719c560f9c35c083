; Types back what is typed on the terminal of an Altair's 88-2SIO, until ESCAPE.
STATUS  EQU     10H
DATA    EQU     11H
        ORG     0
        MVI     A,3             ; reset the 6850
        OUT     STATUS
        MVI     A,15H           ; eight bits, one stop bit, clock divided by 16
        OUT     STATUS
WAIT:   IN      STATUS
        RRC                     ; bit 0: there is a character
        JNC     WAIT
        IN      DATA
        ANI     7FH
        CPI     1BH             ; ESCAPE
        JZ      DONE
        MOV     B,A
SEND:   IN      STATUS
        ANI     2               ; bit 1: one can be sent
        JZ      SEND
        MOV     A,B
        OUT     DATA
        JMP     WAIT
DONE:   HLT
        END     0
