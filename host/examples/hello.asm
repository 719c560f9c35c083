; An 8080 program for CP/M: prints a line with BDOS function 9 and ends with a jump to 0.
        ORG     0100H
        LXI     D,TEXT
        MVI     C,9             ; print up to the $
        CALL    5
        JMP     0
TEXT:   DB      'Hello from an 8080 at 3 MHz',0DH,0AH,'$'
        END
