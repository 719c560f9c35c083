; Keys of points of 12 bits: the squares of all differences are a table, on both sides of SQ4, so that no sign is looked at, and the address is
; one addition. Points are kept times four, as the table has them. 24 bits.

; SQ4 + 4d and SQ4 - 4d for d from 0 to 4095. The square is in HL and B, the odd number in DE.
TABLE:  LXI     H,SQ4
        SHLD    TABUP
        SHLD    TABDN
        LXI     H,0
        LXI     D,1
        MVI     B,0
TABLE1: PUSH    D
        XCHG                    ; DE = the square
        LHLD    TABUP
        CALL    TABPUT
        SHLD    TABUP
        LHLD    TABDN
        CALL    TABPUT
        PUSH    D
        LXI     D,-8
        DAD     D
        POP     D
        SHLD    TABDN
        XCHG
        POP     D
        DAD     D
        MOV     A,B
        ACI     0
        MOV     B,A
        INX     D
        INX     D
        MOV     A,D             ; the odd number after that of 4095 is 2001
        CPI     20H
        JNZ     TABLE1
        RET
; Stores B D E at HL, low byte first; advances HL by four.
TABPUT: MOV     M,E
        INX     H
        MOV     M,D
        INX     H
        MOV     M,B
        INX     H
        INX     H
        RET
TABUP:  DW      0
TABDN:  DW      0

; Number E of the list at HL (put into the instruction by its routine's first line), and the stack pointer at its coordinates.
PICKW   MACRO
        IF      FACING
        LXI     H,0
        MOV     E,M
        MOV     L,E
        MVI     H,PLACEP
        MOV     A,M
        INR     H
        MOV     H,M
        MOV     L,A
        SPHL
        ENDIF
        ENDM
; The next of the list, or HL as it was.
NEXTW   MACRO   LOOP
        LXI     H,LOOP+1
        INR     M
        JNZ     LOOP
        ENDM

; SQ4 - 4 EYE into an LXI or two halves of an addition. The eye is kept times four.
EYET    MACRO   FROM
        LHLD    FROM
        XRA     A
        SUB     L
        MOV     L,A
        MVI     A,SQ4P
        SBB     H
        MOV     H,A
        ENDM

; The entry of the next coordinate, added to D B C. The stack pointer reads the points.
NEXTT   MACRO   LOW,HIGH
        POP     H
        MOV     A,L
LOW:    ADI     0
        MOV     L,A
        MOV     A,H
HIGH:   ACI     0
        MOV     H,A
        MOV     A,M
        ADD     C
        MOV     C,A
        INR     L
        MOV     A,M
        ADC     B
        MOV     B,A
        INR     L
        MOV     A,M
        ADC     D
        MOV     D,A
        ENDM
FIRSTT  MACRO   NAME
        POP     H
NAME:   LXI     B,0
        DAD     B
        MOV     C,M
        INR     L
        MOV     B,M
        INR     L
        MOV     D,M
        ENDM
; The key of number E, and the next number.
KEEPT   MACRO
        MOV     L,E
        MVI     H,K2P
        MOV     M,C
        DCR     H
        MOV     M,B
        DCR     H
        MOV     M,D
        INR     E
        ENDM

KEYT2:
        IF      FACING
        SHLD    KEYT2L+1
        ENDIF
        EYET    EYE
        SHLD    ET2X+1
        EYET    EYE+2
        MOV     A,L
        STA     ET2YL+1
        MOV     A,H
        STA     ET2YH+1
        IF      FACING-1
        LDA     TOTAL
        INR     A
        STA     ET2N+1
        ENDIF
        LXI     H,0
        DAD     SP
        SHLD    KEYSP
        LXI     SP,POINTS
        MVI     E,1
KEYT2L: PICKW
        FIRSTT  ET2X
        NEXTT   ET2YL,ET2YH
        KEEPT
        IF      FACING
        NEXTW   KEYT2L
        ELSE
        MOV     A,E
ET2N:   CPI     0
        JNZ     KEYT2L
        ENDIF
        LHLD    KEYSP
        SPHL
        RET

KEYT3:
        IF      FACING
        SHLD    KEYT3L+1
        ENDIF
        EYET    EYE
        SHLD    ET3X+1
        EYET    EYE+2
        MOV     A,L
        STA     ET3YL+1
        MOV     A,H
        STA     ET3YH+1
        EYET    EYE+4
        MOV     A,L
        STA     ET3ZL+1
        MOV     A,H
        STA     ET3ZH+1
        IF      FACING-1
        LDA     TOTAL
        INR     A
        STA     ET3N+1
        ENDIF
        LXI     H,0
        DAD     SP
        SHLD    KEYSP
        LXI     SP,POINTS
        MVI     E,1
KEYT3L: PICKW
        FIRSTT  ET3X
        NEXTT   ET3YL,ET3YH
        NEXTT   ET3ZL,ET3ZH
        KEEPT
        IF      FACING
        NEXTW   KEYT3L
        ELSE
        MOV     A,E
ET3N:   CPI     0
        JNZ     KEYT3L
        ENDIF
        LHLD    KEYSP
        SPHL
        RET
KEYSP:  DW      0
