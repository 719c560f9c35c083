; The 8080 assembler: each form once. Look at the listing beside it: lines with + come from macros.
COUNT   EQU     5               ; `sightline asm i8080 -D COUNT=7` wins over this line
PRINT   MACRO   TEXT            ; a macro with an argument
        LOCAL   OVER
        JMP     OVER
        DB      TEXT,0
OVER:   NOP
        ENDM

        ORG     0100H
START:  LXI     H,TABLE+2       ; expressions are known names, numbers and operators
        MVI     A,'A' OR 80H
        MVI     B,LOW TABLE     ; LOW and HIGH take a byte of an address
        JMP     $+3             ; $ is this address
        PRINT   <'A, B'>        ; < > keep the comma in one argument
        REPT    2
        INX     H
        ENDM
        IF      COUNT GT 4
        MVI     C,COUNT
        ELSE
        MVI     C,0
        ENDIF
        HLT ! NOP               ; ! separates statements
TABLE:  DB      'it''s',0DH,10,0AH,17Q,1010B
        DW      TABLE,4142H     ; low byte first: 42 41
        DS      3
        END     START
