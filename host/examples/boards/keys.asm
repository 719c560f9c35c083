; Types back each key, until ESCAPE. Between keys the processor halts: each key interrupts it. Look at EI: it acts after HLT.
CONTROL EQU     10H
DATA    EQU     11H
        ORG     0
        LXI     SP,100H
        MVI     A,3             ; reset the 6850
        OUT     CONTROL
        MVI     A,95H           ; eight bits, one stop bit, clock divided by 16, interrupt by a character
        OUT     CONTROL
NEXT:   EI                      ; acts after the next instruction: no key is missed before HLT
        HLT                     ; a key ends it; RST 7 returns to the instruction that follows
        LDA     KEY
        CPI     1BH             ; ESCAPE
        JZ      DONE
        OUT     DATA
        JMP     NEXT
DONE:   HLT                     ; interrupts are off: nothing ends it
        ORG     38H             ; RST 7
        IN      DATA            ; the character; its interrupt request ends
        ANI     7FH
        STA     KEY
        RET                     ; interrupts stay off until NEXT
KEY:    DS      1
        END     0
