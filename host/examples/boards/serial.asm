; 8251: sends back what the host sends, to the first line feed. Look at the start: mode first, then command.
DATA    EQU     0ECH
CONTROL EQU     0EDH

        ORG     0100H
        MVI     A,4EH           ; mode: 8 bits, no parity, 1 stop bit, clock x16
        OUT     CONTROL
        MVI     A,37H           ; command: transmitter, receiver, DTR, RTS on; errors cleared
        OUT     CONTROL
NEXT:   IN      CONTROL
        ANI     02H             ; RxRDY
        JZ      NEXT
        IN      DATA
        MOV     B,A
FULL:   IN      CONTROL
        ANI     01H             ; TxRDY
        JZ      FULL
        MOV     A,B
        OUT     DATA
        CPI     0AH
        JNZ     NEXT
LAST:   IN      CONTROL
        ANI     04H             ; TxEMPTY: the last bit is out
        JZ      LAST
        HLT
        END
