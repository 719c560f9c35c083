; An 8080 program for CP/M that asks and answers. Look at function 10: it reads a line that the user can mend.
        ORG     0100H
        LXI     D,ASK
        MVI     C,9             ; print up to the $
        CALL    5
        LXI     D,LINE
        MVI     C,10            ; read a line: its length comes to LINE+1, its characters behind that
        CALL    5
        LXI     D,HELLO
        MVI     C,9
        CALL    5
        LXI     H,LINE+1
        MOV     B,M
NEXT:   MOV     A,B
        ORA     A
        JZ      0
        INX     H
        PUSH    H
        PUSH    B
        MOV     E,M
        MVI     C,2             ; print a character
        CALL    5
        POP     B
        POP     H
        DCR     B
        JMP     NEXT
ASK:    DB      'What is your name? $'
HELLO:  DB      0AH,'Hello, $'
LINE:   DB      40
        DS      41
        END
