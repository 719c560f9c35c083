; Keys of points whose coordinates are words. The square of a difference 256 h + l is 65536 h*h + 256 (h*h + l*l - (h-l)*(h-l)) + l*l, with squares of
; bytes only. Of all axes together: H the sum of h*h, L of l*l, C of (h-l)*(h-l). 32 bits.

; The difference of the next coordinate: l and |h - l| go into the instructions that will look them up; D = h. The stack pointer reads the points.
DIFFW   MACRO   LOW,HIGH,ILOW,IDIFF
        LOCAL   POS,POS2
        POP     D
        MOV     A,E
LOW:    SUI     0               ; the eye's
        MOV     E,A
        MOV     A,D
HIGH:   SBI     0
        MOV     D,A
        JNC     POS
        CMA
        MOV     D,A
        MOV     A,E
        CMA
        MOV     E,A
        INX     D
POS:    MOV     A,E
        STA     ILOW+1
        SUB     D
        JNC     POS2
        CMA
        INR     A
POS2:   STA     IDIFF+1
        MOV     L,D
        MVI     H,SQLP
        ENDM

; BC = H
FIRSTH  MACRO
        MOV     C,M
        INR     H
        MOV     B,M
        ENDM
NEXTH   MACRO
        MOV     A,M
        ADD     C
        MOV     C,A
        INR     H
        MOV     A,M
        ADC     B
        MOV     B,A
        ENDM

; DE = L; the carry out of it is left.
FIRSTL  MACRO   ILOW
        MVI     H,SQLP
ILOW:   MVI     L,0
        MOV     E,M
        INR     H
        MOV     D,M
        ENDM
NEXTL   MACRO   ILOW
        DCR     H
ILOW:   MVI     L,0
        MOV     A,M
        ADD     E
        MOV     E,A
        INR     H
        MOV     A,M
        ADC     D
        MOV     D,A
        ENDM

; THIRD and DE = H + L + L / 256, with A the third byte of L; the low byte of L goes where it will be stored as K3.
JOIN    MACRO   THIRD,LOWEST
        MOV     L,D
        MOV     H,A
        DAD     D
        ACI     0
        DAD     B
        ACI     0
        STA     THIRD+1
        XCHG
        MOV     A,L
        STA     LOWEST+1
        ENDM

; THIRD and DE - (h-l)*(h-l)
LESSC   MACRO   IDIFF,THIRD
        LOCAL   NOBORR
        MVI     H,SQLP
IDIFF:  MVI     L,0
        MOV     A,E
        SUB     M
        MOV     E,A
        INR     H
        MOV     A,D
        SBB     M
        MOV     D,A
        JNC     NOBORR
        LXI     H,THIRD+1
        DCR     M
NOBORR:
        ENDM

; The key of the number in the instruction NUM, and the next number, or the next of the list.
KEEPW   MACRO   NUM,LAST,THIRD,LOWEST,LOOP
        MOV     A,D
        ADD     C
        MOV     D,A
THIRD:  MVI     A,0
        ADC     B
        MVI     H,K0P
NUM:    MVI     L,0
        MOV     M,A
        INR     H
        MOV     M,D
        INR     H
        MOV     M,E
        INR     H
LOWEST: MVI     M,0
        IF      FACING
        NEXTW   LOOP
        ELSE
        INR     L
        MOV     A,L
        STA     NUM+1
LAST:   CPI     0
        JNZ     LOOP
        ENDIF
        LHLD    KEYSP
        SPHL
        RET
        ENDM

BEGINW  MACRO   NUM,LAST
        IF      FACING-1
        MVI     A,1
        STA     NUM+1
        LDA     TOTAL
        INR     A
        STA     LAST+1
        ENDIF
        LXI     H,0
        DAD     SP
        SHLD    KEYSP
        LXI     SP,POINTS
        ENDM

; The eye's coordinate into the two instructions that subtract it.
EYEW    MACRO   FROM,LOW,HIGH
        LHLD    FROM
        MOV     A,L
        STA     LOW+1
        MOV     A,H
        STA     HIGH+1
        ENDM

KEYW2:
        IF      FACING
        SHLD    KEYW2L+1
        ENDIF
        EYEW    EYE,EW2XL,EW2XH
        EYEW    EYE+2,EW2YL,EW2YH
        BEGINW  NUMW2,LASTW2
KEYW2L: PICKW
        IF      FACING
        MOV     A,E
        STA     NUMW2+1
        ENDIF
        DIFFW   EW2XL,EW2XH,LW2X,CW2X
        FIRSTH
        DIFFW   EW2YL,EW2YH,LW2Y,CW2Y
        NEXTH
        FIRSTL  LW2X
        NEXTL   LW2Y
        MVI     A,0
        ACI     0
        JOIN    THRDW2,LWSTW2
        LESSC   CW2X,THRDW2
        LESSC   CW2Y,THRDW2
        KEEPW   NUMW2,LASTW2,THRDW2,LWSTW2,KEYW2L

KEYW3:
        IF      FACING
        SHLD    KEYW3L+1
        ENDIF
        EYEW    EYE,EW3XL,EW3XH
        EYEW    EYE+2,EW3YL,EW3YH
        EYEW    EYE+4,EW3ZL,EW3ZH
        BEGINW  NUMW3,LASTW3
KEYW3L: PICKW
        IF      FACING
        MOV     A,E
        STA     NUMW3+1
        ENDIF
        DIFFW   EW3XL,EW3XH,LW3X,CW3X
        FIRSTH
        DIFFW   EW3YL,EW3YH,LW3Y,CW3Y
        NEXTH
        DIFFW   EW3ZL,EW3ZH,LW3Z,CW3Z
        NEXTH
        FIRSTL  LW3X
        NEXTL   LW3Y
        SBB     A
        STA     CARRY           ; 0, or FF for a carry
        NEXTL   LW3Z
        MVI     A,0
        ACI     0
        LXI     H,CARRY
        SUB     M
        JOIN    THRDW3,LWSTW3
        LESSC   CW3X,THRDW3
        LESSC   CW3Y,THRDW3
        LESSC   CW3Z,THRDW3
        KEEPW   NUMW3,LASTW3,THRDW3,LWSTW3,KEYW3L

CARRY:  DB      0
