; CalComp 565: draws a step file (`sightline draw ... --device calcomp`) that the host sends to port A of the 8255.
PLOTTER EQU     60H
PORTA   EQU     0E4H
PORTC   EQU     0E6H
CONTROL EQU     0E7H

        ORG     0100H
        MVI     A,0B4H          ; A: mode 1 input
        OUT     CONTROL
NEXT:   IN      PORTC
        ANI     20H             ; IBF of port A: a byte is there
        JZ      NEXT
        IN      PORTA
        CPI     0FFH            ; the end of the file
        JZ      LAST
        MOV     B,A
WAIT:   IN      PLOTTER
        RRC                     ; bit 0, BUSY, into the carry
        JC      WAIT
        MOV     A,B
        OUT     PLOTTER
        JMP     NEXT
LAST:   IN      PLOTTER
        RRC
        JC      LAST
        HLT
        END
