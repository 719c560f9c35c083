; A CP/M program that copies a file: sightline run i8080 copy.com --cpm --cpm-drive a=. --cpm-args "FROM.TXT TO.TXT"
; The names are in the file control blocks at 5C and 6C, where CP/M puts those behind the program's name.
BDOS    EQU     5
FROM    EQU     5CH
SECOND  EQU     6CH

        ORG     0100H
        LXI     H,SECOND        ; opening the first file would cover the second name
        LXI     D,TO
        MVI     B,12
MOVE:   MOV     A,M
        STAX    D
        INX     H
        INX     D
        DCR     B
        JNZ     MOVE

        XRA     A
        STA     FROM+32         ; begin with its first record
        LXI     D,FROM
        MVI     C,15            ; open
        CALL    BDOS
        INR     A               ; 255 is an error
        LXI     D,NOFILE
        JZ      FAIL
        LXI     D,TO
        MVI     C,19            ; delete what has the name
        CALL    BDOS
        LXI     D,TO
        MVI     C,22            ; make
        CALL    BDOS
        INR     A
        LXI     D,NOROOM
        JZ      FAIL

NEXT:   LXI     D,FROM
        MVI     C,20            ; read a record of 128 bytes to 0080
        CALL    BDOS
        ORA     A
        JNZ     CLOSE           ; the end of the file
        LXI     D,TO
        MVI     C,21            ; write it
        CALL    BDOS
        ORA     A
        LXI     D,NOROOM
        JNZ     FAIL
        JMP     NEXT

CLOSE:  LXI     D,TO
        MVI     C,16
        CALL    BDOS
        JMP     0

FAIL:   MVI     C,9             ; print up to the $
        CALL    BDOS
        JMP     0

NOFILE: DB      'No file$'
NOROOM: DB      'No room$'
TO:     DS      12
        DB      0,0,0,0         ; extent and counts
        DS      16
        DB      0               ; next record
        END
