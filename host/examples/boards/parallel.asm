; 8255: sends back to the host, on port B, what the host sends on port A, to the first line feed. Look at the control word.
PORTA   EQU     0E4H
PORTB   EQU     0E5H
PORTC   EQU     0E6H
CONTROL EQU     0E7H

        ORG     0100H
        MVI     A,0B4H          ; A: mode 1 input; B: mode 1 output
        OUT     CONTROL
NEXT:   IN      PORTC
        ANI     20H             ; IBF of port A: a byte is there
        JZ      NEXT
        IN      PORTA           ; IBF falls, the host may send the next
        MOV     B,A
FULL:   IN      PORTC
        ANI     02H             ; OBF# of port B: 1 when the host has taken the last byte
        JZ      FULL
        MOV     A,B
        OUT     PORTB
        CPI     0AH
        JNZ     NEXT
LAST:   IN      PORTC
        ANI     02H
        JZ      LAST
        HLT
        END
