; Depth relations: which of two faces is in front. Source: SPECIFICATION.md, section 5.

FI:     DB      0               ; the pair
FJ:     DB      0
EI:     DW      0               ; entry of the first
EJ:     DW      0
SIDEI:  DB      0               ; of the first with the plane of the second: bit 0 near, bit 1 far
SIDEJ:  DB      0
PLANE:  DW      0
WIDE:   DB      0               ; the widest common substripe
WIDEW:  DB      0
WIDEY:  DB      0
PV:     DW      0,0             ; a point: X, Y
ZFACE:  DB      0

; Carry: the word at DE is less than that at HL. Changes A only, and the pointers by one.
LESS:   LDAX    D
        SUB     M
        INX     D
        INX     H
        LDAX    D
        SBB     M
        RET

; DE = entry of the first plus B, HL = of the second plus C. Entries do not cross a page.
IJ:     LHLD    EI
        MOV     A,L
        ADD     B
        MOV     E,A
        MOV     D,H
        LHLD    EJ
        MOV     A,L
        ADD     C
        MOV     L,A
        RET

; Test 1. Carry: there is more of the second in X, or of what follows it.
TEST1:  LDA     FI
        CALL    EXTOF
        SHLD    EI
        LDA     FJ
        CALL    EXTOF
        SHLD    EJ
        LXI     B,0200H
        CALL    IJ
        XCHG
        JMP     LESS            ; least X of j < greatest of i

; Tests 2 to 6: the relation of the pair, if any, into the tables.
TESTS:  LXI     B,0C0DH
        CALL    IJ
        LDAX    D
        CMP     M
        RNC
        LXI     B,0D0CH
        CALL    IJ
        XCHG
        LDAX    D
        CMP     M
        RNC
        LXI     B,080AH         ; greatest Z of j < least of i
        CALL    IJ
        XCHG
        CALL    LESS
        JC      JFIRST
        LXI     B,0A08H         ; greatest of i < least of j
        CALL    IJ
        CALL    LESS
        JC      IFIRST
        LDA     FI
        MOV     B,A
        LDA     FJ
        MOV     C,A
        PUSH    B
        CALL    SIDES
        STA     SIDEI
        POP     B
        CPI     3
        RZ
        MOV     A,B
        MOV     B,C
        MOV     C,A
        CALL    SIDES
        CPI     3
        RZ
        ADD     A
        ADD     A
        MOV     B,A
        LDA     SIDEI
        ORA     B               ; bits: 0 i near, 1 i far, 2 j near, 3 j far
        MOV     B,A
        ANI     9
        JNZ     IFIRST
        MOV     A,B
        ANI     6
        JNZ     JFIRST
        ; Test 6
        CALL    TEST6
        LDA     WIDE
        ORA     A
        RZ
        MOV     L,A
        LDA     WIDEW           ; its middle: w + e is e - w and twice w
        MOV     E,A
        MVI     H,0
        MOV     D,H
        DAD     D
        DAD     D
        DAD     H
        DAD     H
        DAD     H
        DAD     H
        DAD     H
        DAD     H
        DAD     H
        SHLD    PV
        LDA     WIDEY
        MOV     H,A
        MVI     L,128
        SHLD    PV+2
        LDA     FI
        CALL    ZAT
        PUSH    D
        LDA     FJ
        CALL    ZAT
        POP     H
        MVI     A,3
        STA     RELATE
        MOV     A,L             ; HL that of i, DE of j
        SUB     E
        MOV     B,A
        MOV     A,H
        SBB     D
        JC      IFIRS1
        ORA     B
        JNZ     JFIRS1
        RET

RELATE: DB      0               ; 1 by tests 3 to 5, 3 by test 6

IFIRST: MVI     A,1
        STA     RELATE
IFIRS1: LDA     FI
        MOV     B,A
        LDA     FJ
        MOV     C,A
        JMP     HIDES
JFIRST: MVI     A,1
        STA     RELATE
JFIRS1: LDA     FJ
        MOV     B,A
        LDA     FI
        MOV     C,A
        ; B hides C
HIDES:  CALL    RELOF
        LDA     RELATE
        MOV     M,A
        MVI     A,LOW NMIN
        ADD     B
        MOV     L,A
        MVI     H,HIGH NMIN
        INR     M
        MVI     A,LOW NMAX
        ADD     C
        MOV     L,A
        MVI     H,HIGH NMAX
        INR     M
        RET

; HL = where the relation "B hides C" is.
RELOF:  MOV     L,B
        MVI     H,0
        DAD     H
        DAD     H
        DAD     H
        DAD     H
        DAD     H
        DAD     H
        MOV     A,L
        ORA     C
        MOV     L,A
        MOV     A,H
        ADI     SS SHR 8
        MOV     H,A
        RET

; A = sides of the vertices of face B with the plane of C: bit 0 all near, bit 1 all far.
SIDES:  MOV     A,C
        CALL    RECOF
        LXI     D,RPLANE
        DAD     D
        SHLD    PLANE
        MOV     A,B
        CALL    RECOF
        LXI     D,RRINGS
        DAD     D
        MOV     A,M
        STA     RINGS
        INX     H
        MVI     A,3
        STA     SIDE
SIDES1: MOV     A,M
        STA     VERTS
        INX     H
SIDES2: PUSH    H
        XCHG
        LHLD    PLANE
        XCHG
        MVI     A,3
        CALL    PLANEV
        LHLD    ACC+2           ; v >> 16, signed
        MOV     A,H
        ORA     A
        JM      SIDES4
        ORA     A
        JNZ     SIDES3
        MOV     A,L
        CPI     2
        JC      SIDES6
SIDES3: MVI     B,2
        JMP     SIDES5
SIDES4: INR     A
        JNZ     SIDES7
        MOV     A,L
        CPI     0FEH
        JNC     SIDES6
SIDES7: MVI     B,1
SIDES5: LDA     SIDE
        ANA     B
        STA     SIDE
SIDES6: POP     H
        LXI     D,6
        DAD     D
        LDA     SIDE
        ORA     A
        RZ
        XCHG
        LXI     H,VERTS
        DCR     M
        XCHG
        JNZ     SIDES2
        XCHG
        LXI     H,RINGS
        DCR     M
        XCHG
        JNZ     SIDES1
        RET                     ; A = SIDE
SIDE:   DB      0

; The widest common substripe of the pair; WIDE = 0: there is none.
TEST6:  XRA     A
        STA     WIDE
        MVI     A,FS SHR 8
        STA     BASEH
        LDA     FI
        CALL    BUILD
        LHLD    YLO
        SHLD    YF
        MVI     A,VS SHR 8
        STA     BASEH
        LDA     FJ
        CALL    BUILD
        CALL    COMMON
TEST61: CALL    PAIR
        RZ
        MOV     A,M             ; an empty list has nothing in common
        INR     A
        JZ      TEST64
        LDAX    D
        INR     A
        JZ      TEST64
        PUSH    H
        CALL    MERGE
        LXI     H,T1
        MVI     B,64
        CALL    TAKEV
        POP     H
        LXI     D,T1
        CALL    MERGE
        LXI     H,VTOP-1
TEST62: MOV     A,M
        CPI     255
        JZ      TEST64
        MOV     B,A             ; from
        DCX     H
        DCX     H
        MOV     A,M             ; to before
        MOV     C,A
        SUB     B
        MOV     D,A
        LDA     WIDE
        CMP     D
        JNC     TEST63
        MOV     A,D
        STA     WIDE
        MOV     A,B
        STA     WIDEW
        LDA     LINE
        STA     WIDEY
TEST63: INR     C
        JZ      TEST64
        DCX     H
        DCX     H
        JMP     TEST62
TEST64: LXI     H,LINE
        INR     M
        JMP     TEST61

; DE = depth of face A at the point PV.
ZAT:    STA     ZFACE
        CALL    RECOF
        LXI     D,RPLANE
        DAD     D
        XCHG
        LXI     H,PV
        MVI     A,2
        CALL    PLANEV
        LHLD    CP
        MOV     C,M
        INX     H
        MOV     B,M             ; c
        LHLD    ACC             ; HL:DE = - ACC
        XRA     A
        SUB     L
        MOV     E,A
        MVI     A,0
        SBB     H
        MOV     D,A
        LHLD    ACC+2
        MVI     A,0
        SBB     L
        MOV     L,A
        MVI     A,0
        SBB     H
        MOV     H,A
        ORA     A
        JM      ZAT1
        MOV     A,L
        SUB     C
        MOV     A,H
        SBB     B
        JNC     ZAT2
        CALL    DIVIDE
        JMP     ZAT3
ZAT1:   LXI     D,0
        JMP     ZAT3
ZAT2:   LXI     D,0FFFFH
ZAT3:   LDA     ZFACE           ; within the face's Z
        PUSH    D
        CALL    EXTOF
        LXI     D,8
        DAD     D
        POP     D
        MOV     C,M
        INX     H
        MOV     B,M
        INX     H
        MOV     A,E
        SUB     C
        MOV     A,D
        SBB     B
        JC      ZAT4
        MOV     C,M
        INX     H
        MOV     B,M
        MOV     A,C
        SUB     E
        MOV     A,B
        SBB     D
        RNC
ZAT4:   MOV     D,B
        MOV     E,C
        RET
