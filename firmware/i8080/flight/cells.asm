; Cells: what touches is kept apart by planes, and the cells on the eye's side of a plane come before those on the other. The eye is on the side of
; whichever of the plane's two points is nearer.

; ---- Receipt: of each plane three places, then the cell of each piece, piece N first. A place is 0 for nothing, 1 to 127 for a cell, 80H + i for
; plane i, which follows its parent. Each cell and plane occurs once. D = t, E = s, as in all receipt.
GETCEL: LXI     H,NEXT          ; and SIZE and USED
        MVI     C,3
        XRA     A
GETC1:  MOV     M,A
        INR     L
        JNZ     GETC1
        INR     H
        DCR     C
        JNZ     GETC1
        MVI     B,RANGE
        LXI     H,NODES
        MVI     C,1             ; the plane's number
GETC2:  CALL    GETPLC
        CALL    GETPLC
        CALL    GETPLC
        LDA     PLANES
        CMP     C
        JZ      GETC3
        INR     C
        JMP     GETC2
GETC3:  LDA     COUNT
        MOV     L,A
GETC4:  MVI     H,CELLP
        CALL    GETB
        MOV     M,A
        DCR     A
        CPI     127
        JNC     STOP
        INR     A
        MOV     C,L
        MOV     L,A
        MVI     H,SIZEP
        INR     M
        MOV     L,C
        DCR     L
        JNZ     GETC4
        RET

; Stores a place at HL and increments HL.
GETPLC: CALL    GETB
        MOV     M,A
        INX     H
        ORA     A
        RZ
        PUSH    H
        JP      GETPL1
        ANI     7FH
        CMP     C
        JC      STOP
        JZ      STOP
        LXI     H,PLANES
        DCR     A
        CMP     M
        JNC     STOP
        ADI     81H
GETPL1: MOV     L,A
        MVI     H,USEDP
        MOV     A,M
        ORA     A
        JNZ     STOP
        INR     M
        POP     H
        RET

; ---- The priority of the first piece of each cell.
RANKS:  LDA     COUNT
        STA     LEFT
        MVI     A,81H
; Place A, and all below it, nearest first.
VISIT:  ORA     A
        RZ
        JM      VISIT1
        MOV     L,A
        MVI     H,NEXTP
        LDA     LEFT
        MOV     M,A
        INR     H
        SUB     M
        STA     LEFT
        RET
VISIT1: ANI     7FH
        MOV     C,A
        DCR     A
        MOV     E,A
        MVI     D,0
        LXI     H,NODES
        DAD     D
        DAD     D
        DAD     D
        PUSH    H
        LDA     COUNT           ; the points of plane C have the numbers N + 2C - 1 and N + 2C
        ADD     C
        ADD     C
        MOV     L,A
        MOV     E,A
        DCR     E
        MVI     H,K0P
        MVI     D,K0P
        MVI     B,4
VISIT2: LDAX    D
        CMP     M
        JNZ     VISIT3
        INR     D
        INR     H
        DCR     B
        JNZ     VISIT2
VISIT3: POP     H
        JC      VISIT4
        JZ      VISIT4
        INX     H
        INX     H
        MOV     A,M
        PUSH    H
        CALL    VISIT
        POP     H
        DCX     H
        MOV     A,M
        PUSH    H
        CALL    VISIT
        POP     H
        DCX     H
        MOV     A,M
        JMP     VISIT
VISIT4: MOV     A,M
        PUSH    H
        CALL    VISIT
        POP     H
        INX     H
        MOV     A,M
        PUSH    H
        CALL    VISIT
        POP     H
        INX     H
        MOV     A,M
        JMP     VISIT
LEFT:   DB      0               ; the priority of the next cell's first piece

; ---- Priorities cell by cell: within one in the order of distance.
LOADC:  LDA     FIRST
        MOV     L,A
        MVI     H,LISTP
LOADC1: MOV     A,M
        OUT     PDNUM
        MOV     E,A
        MVI     D,CELLP
        LDAX    D
        MOV     E,A
        MVI     D,NEXTP
        LDAX    D
        OUT     PDPRI
        DCR     A
        STAX    D
        INR     L
        JNZ     LOADC1
        RET
