; The order, from that of the last frame: little changes from frame to frame, so each piece goes by insertion to its place among those before it.
; And the priorities.

; DE = first two bytes of the key before; HL = place in the order, B = K0P.
ORDER:
        IF      FACING-1        ; with the facing test HL is given
        LDA     FIRST
        MOV     L,A
        MVI     H,LISTP
        ENDIF
        MVI     B,K0P
        LXI     D,0
ORDER1: MOV     C,M
        LDAX    B
        CMP     D
        JC      INSERT
        JZ      SAME
        MOV     D,A
        INR     B
        LDAX    B
        MOV     E,A
        DCR     B
ORDER2: INR     L
        JNZ     ORDER1
        RET

SAME:   INR     B
        LDAX    B
        MVI     B,K0P
        CMP     E
        JC      INSERT
        MOV     E,A
        JNZ     ORDER2
SAMELO: JMP     0               ; the same two bytes: to ORDER2 where keys have no more, else to LOWER (put there by INIT)
LOWER:  PUSH    H
        DCR     L
        MOV     L,M
        MVI     H,K2P
        MVI     B,K2P
        LDAX    B
        CMP     M
        JNZ     LOWER1
        INR     B
        INR     H
        LDAX    B
        CMP     M
LOWER1: MVI     B,K0P
        POP     H
        JNC     ORDER2

; Piece C belongs before the piece before it.
INSERT: MOV     A,C
        STA     CUR+1
        PUSH    H
        PUSH    D               ; the last one stays last
        LDAX    B
        MOV     D,A
        INR     B
        LDAX    B
        MOV     E,A
        DCR     B
        DCR     L
        MOV     C,M
SHIFT:  INR     L
        MOV     M,C
        DCR     L
        DCR     L
        MOV     C,M
        LDAX    B
        CMP     D
        JC      PUT
        JNZ     SHIFT
        INR     B
        LDAX    B
        MVI     B,K0P
        CMP     E
        JC      PUT
        JNZ     SHIFT
SHIFLO: JMP     0               ; to PUT or SHIFT1, likewise
SHIFT1: CALL    LOWCMP
        JC      PUT
        JNZ     SHIFT
PUT:    INR     L
CUR:    MVI     M,0             ; piece C, put there by INSERT
        POP     D
        POP     H
        JMP     ORDER2

; The last two bytes of the keys of C and of the piece in CUR: carry if that of C is less, zero if they are the same.
LOWCMP: PUSH    H
        LDA     CUR+1
        MOV     L,A
        MVI     H,K2P
        MVI     B,K2P
        LDAX    B
        CMP     M
        JNZ     LOWCM1
        INR     B
        INR     H
        LDAX    B
        CMP     M
LOWCM1: MVI     B,K0P
        POP     H
        RET

; ---- The nearest piece gets the priority N, the farthest 1.
LOAD:
        IF      FACING
        CALL    LOADA
        RZ
        ENDIF
        LDA     PLANES
        ORA     A
        JNZ     LOADC
        LDA     COUNT
        MOV     B,A
        LDA     FIRST
        MOV     L,A
        MVI     H,LISTP
LOAD1:  MOV     A,M
        OUT     PDNUM
        MOV     A,B
        OUT     PDPRI
        DCR     B
        INR     L
        JNZ     LOAD1
        RET
