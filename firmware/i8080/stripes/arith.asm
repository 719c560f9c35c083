; Arithmetic of planes. Source: SPECIFICATION.md, section 5.

ACC:    DB      0,0,0,0,0       ; 32 bits, and one byte that a carry may spoil
SGN:    DB      0
MHI:    DB      0
TERMS:  DB      0
VP:     DW      0
CP:     DW      0

; ACC = a X + b Y (+ c Z, with A = 3 terms instead of 2) - d, of the vertex at HL and the plane at DE. CP is then after the last
; coefficient.
PLANEV: STA     TERMS
        SHLD    VP
        XCHG
        SHLD    CP
        LXI     D,6
        DAD     D
        LXI     D,ACC
        MVI     C,4
        ORA     A
PLANE1: MVI     A,0
        SBB     M
        STAX    D
        INX     H
        INX     D
        DCR     C
        JNZ     PLANE1
PLANE2: LHLD    CP
        MOV     C,M
        INX     H
        MOV     B,M
        INX     H
        SHLD    CP
        LHLD    VP
        MOV     E,M
        INX     H
        MOV     D,M
        INX     H
        SHLD    VP
        CALL    MULADD
        LXI     H,TERMS
        DCR     M
        JNZ     PLANE2
        RET

; ACC = ACC + BC * DE, BC signed, DE not.
MULADD: MOV     A,B
        ADD     A
        SBB     A
        STA     SGN
        JZ      MULA1
        XRA     A
        SUB     C
        MOV     C,A
        MVI     A,0
        SBB     B
        MOV     B,A
MULA1:  MOV     A,D
        STA     MHI
        MOV     A,E
        CALL    MUL8
        LXI     D,ACC
        CALL    ADD24
        LDA     MHI
        CALL    MUL8
        LXI     D,ACC+1
        ; fall through

; Three bytes from DE on, and a carry into the fourth: + or - A:HL.
ADD24:  PUSH    B
        MOV     B,A
        LDA     SGN
        ORA     A
        JNZ     SUB24
        LDAX    D
        ADD     L
        STAX    D
        INX     D
        LDAX    D
        ADC     H
        STAX    D
        INX     D
        LDAX    D
        ADC     B
        STAX    D
        POP     B
        RNC
        INX     D
        LDAX    D
        INR     A
        STAX    D
        RET
SUB24:  LDAX    D
        SUB     L
        STAX    D
        INX     D
        LDAX    D
        SBB     H
        STAX    D
        INX     D
        LDAX    D
        SBB     B
        STAX    D
        POP     B
        RNC
        INX     D
        LDAX    D
        DCR     A
        STAX    D
        RET

; A:HL = A * BC. Changes D.
MUL8:   LXI     H,0
        MVI     D,8
MUL81:  DAD     H
        RAL
        JNC     MUL82
        DAD     B
        ACI     0
MUL82:  DCR     D
        JNZ     MUL81
        RET

; DE = HL:DE / BC, HL below BC, BC below 8000H.
DIVIDE: MVI     A,16
DIVID1: PUSH    PSW
        XCHG
        DAD     H
        XCHG
        MOV     A,L
        RAL
        MOV     L,A
        MOV     A,H
        RAL
        MOV     H,A
        MOV     A,L
        SUB     C
        MOV     A,H
        SBB     B
        JC      DIVID2
        MOV     H,A
        MOV     A,L
        SUB     C
        MOV     L,A
        INR     E
DIVID2: POP     PSW
        DCR     A
        JNZ     DIVID1
        RET
