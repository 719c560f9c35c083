; Keys of points whose coordinates are bytes: squares of differences from a table, 16 bits.

; Where only some points get a key: their numbers are the list at HL (put into the instruction by its first line), and L is the next of them.
PICKB   MACRO
        IF      FACING
        LXI     H,0
        MOV     L,M
        ENDIF
        ENDM

; The difference of M from the eye, as an index in C.
DIFFB   MACRO   NAME
        LOCAL   POS
        MOV     A,M
NAME:   SUI     0               ; the eye's coordinate, put there every frame
        JNC     POS
        CMA
        INR     A
POS:    MOV     C,A
        ENDM

; Its square into DE, or added to DE. B is SQHP before and after.
FIRSTB  MACRO
        DCR     B
        LDAX    B
        MOV     E,A
        INR     B
        LDAX    B
        MOV     D,A
        ENDM
NEXTB   MACRO
        DCR     B
        LDAX    B
        ADD     E
        MOV     E,A
        INR     B               ; keeps the carry
        LDAX    B
        ADC     D
        MOV     D,A
        ENDM
; The key of number L, and the next lower number, or the next of the list.
KEEPB   MACRO   LOOP
        MVI     H,K1P
        MOV     M,E
        DCR     H
        MOV     M,D
        IF      FACING
        LXI     H,LOOP+1
        INR     M
        ELSE
        DCR     L
        ENDIF
        JNZ     LOOP
        RET
        ENDM

KEYB2:
        IF      FACING
        SHLD    KEYB2L+1
        ENDIF
        LDA     EYE
        STA     EB2X+1
        LDA     EYE+1
        STA     EB2Y+1
        IF      FACING-1
        LDA     TOTAL
        MOV     L,A
        ENDIF
        MVI     B,SQHP
KEYB2L: PICKB
        MVI     H,XBP
        DIFFB   EB2X
        FIRSTB
        INR     H
        DIFFB   EB2Y
        NEXTB
        KEEPB   KEYB2L

KEYB3:
        IF      FACING
        SHLD    KEYB3L+1
        ENDIF
        LDA     EYE
        STA     EB3X+1
        LDA     EYE+1
        STA     EB3Y+1
        LDA     EYE+2
        STA     EB3Z+1
        IF      FACING-1
        LDA     TOTAL
        MOV     L,A
        ENDIF
        MVI     B,SQHP
KEYB3L: PICKB
        MVI     H,XBP
        DIFFB   EB3X
        FIRSTB
        INR     H
        DIFFB   EB3Y
        NEXTB
        INR     H
        DIFFB   EB3Z
        NEXTB
        KEEPB   KEYB3L
