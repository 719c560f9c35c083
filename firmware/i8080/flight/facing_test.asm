; The facing test: which pieces face the eye, and keys and places in the order only for them.
;
; Of a direction the eye's value is the difference of two keys, so it takes no multiplication. The planes across a direction are
; in the order of their values, and REACHED is between those that the eye has passed and the others. From frame to frame it
; moves past few planes or none, and only the pieces of these turn.

; ---- Receipt, after the cells: of each direction the number of its entries, then the entries. D = t, E = s, as in all receipt.
GETENT: LXI     H,FACE
        MVI     A,0FFH
GETE1:  MOV     M,A
        INR     L
        JNZ     GETE1
        MOV     M,L             ; number 0 is no piece
        LXI     H,REACHED
        SHLD    SIDEP
        LXI     H,ENTRIES
        LDA     MDIRS
        STA     DIRS
GETE2:  CALL    ENDENT
        PUSH    D
        XCHG
        LHLD    SIDEP
        MOV     M,E
        INX     H
        MOV     M,D
        INX     H
        SHLD    SIDEP
        XCHG
        POP     D
        CALL    GETB
        ORA     A
        JZ      GETE8
GETE3:  STA     LEFTE
        LDA     PREC            ; a limit has one byte more; the rest is zero, like that of a key
        INR     A
        MOV     C,A
        MVI     B,4
GETE4:  CALL    GETB
        MOV     M,A
        INX     H
        DCR     B
        DCR     C
        JNZ     GETE4
GETE5:  MOV     A,B
        ORA     A
        JZ      GETE6
        MVI     M,0
        INX     H
        DCR     B
        JMP     GETE5
GETE6:  PUSH    D
        PUSH    H
        LXI     D,-5            ; the number of the entry before
        DAD     D
        MOV     A,M
        ORA     A
        JZ      GETE7
        DCX     H
        MOV     E,M
        DCX     H
        MOV     D,M
        DCX     H
        MOV     C,M
        DCX     H
        MOV     B,M
        CALL    NEXTEN
        CALL    COMPAR
        JC      BADENT
GETE7:  POP     H
        POP     D
        CALL    GETB
        MOV     M,A
        MOV     C,A
        LDA     COUNT
        CMP     C
        JC      BADENT
        MOV     A,C
        ORA     A
        JZ      BADENT
        MVI     B,FACEP
        LDAX    B
        INR     A
        JNZ     BADENT          ; it has an entry already
        CALL    GETB
        CPI     2
        JNC     BADENT
        XRI     1               ; of side 0: faces the eye as long as the limit is not passed
        STAX    B
        INX     H
        LDA     LEFTE
        DCR     A
        JNZ     GETE3
GETE8:  LDA     DIRS
        DCR     A
        STA     DIRS
        JNZ     GETE2
        CALL    ENDENT
        LDA     COUNT
        MOV     C,A
        MVI     B,FACEP
GETE9:  LDAX    B
        INR     A
        JZ      BADENT          ; it has none
        DCR     C
        JNZ     GETE9
        RET
BADENT: MVI     B,RANGE
        JMP     STOP

; A sentinel at HL, which no value passes, in the direction before or back in the next; HL after it.
ENDENT: MVI     C,4
ENDEN1: MVI     M,0FFH
        INX     H
        DCR     C
        JNZ     ENDEN1
        MOV     M,C
        INX     H
        RET

NEXTEN: INX     H               ; the entry after that at HL
        INX     H
        INX     H
        INX     H
        INX     H
        RET

; Carry if the limit at HL is less than B C D E.
COMPAR: MOV     A,M
        CMP     B
        RNZ
        INX     H
        MOV     A,M
        CMP     C
        RNZ
        INX     H
        MOV     A,M
        CMP     D
        RNZ
        INX     H
        MOV     A,M
        CMP     E
        RET

; ---- Once for a model: the fixed points, the first order, the places of coordinates.
BEGIN:  LDA     COUNT
        MOV     C,A
        LDA     TOTAL
        MOV     B,A
        LXI     H,FIXED+0FFH
BEGIN1: MOV     M,B
        DCR     L
        DCR     B
        MOV     A,B
        CMP     C
        JNZ     BEGIN1
        MOV     A,L
        INR     A
        STA     FIXED
        LXI     H,LIST+0FFH
        MVI     B,FACEP
BEGIN2: LDAX    B
        ORA     A
        JZ      BEGIN3
        MOV     M,C
        DCR     L
BEGIN3: DCR     C
        JNZ     BEGIN2
        MOV     M,C
        MOV     A,L
        INR     A
        STA     FIRST
        LXI     D,POINTS
        LXI     H,PLACEL+1
BEGIN4: MOV     M,E
        INR     H
        MOV     M,D
        DCR     H
        LDA     AXES
        ADD     A
        ADD     E
        MOV     E,A
        MVI     A,0
        ADC     D
        MOV     D,A
        INR     L
        JNZ     BEGIN4
        RET

; ---- A frame: keys and order of the pieces that face the eye.
FACES:  XRA     A
        STA     NEW
        STA     AWAY
        LXI     H,FIXED
        MOV     L,M
        CALL    KEYS
        CALL    SIDES
        LDA     AWAY
        ORA     A
        CNZ     REMOVE
        MVI     H,LISTP
        LDA     FIRST
        ORA     A
        CNZ     KEYORD
        LXI     H,NEW
        MOV     A,M
        ORA     A
        RZ
        MOV     L,A
        DCR     L
        MVI     M,0             ; the sentinel
        CALL    KEYORD

; The new pieces into the order, from the front: DE = place to be filled, HL = place of the old piece to be compared. An old piece that is behind
; the last new one stays where it is.
        LDA     FIRST
        MOV     L,A
        LDA     NEW             ; 256 less their number
        ADD     L
        STA     FIRST
        MOV     E,A
        MVI     H,LISTP
        MOV     D,H
        DCR     E
        XRA     A
        STAX    D               ; the sentinel
        INR     E
MERGE1: LDA     NEW             ; NEW goes up until it is 256
        MOV     C,A
        MVI     B,NEWP
        LDAX    B
        STA     CUR+1
        MOV     C,A
        MVI     B,K0P
        LDAX    B
        STA     MERGE3+1
        INR     B
        LDAX    B
        STA     MERGE4+1
        DCR     B
        MOV     A,L
        ORA     A
        JZ      MERGE6
MERGE2: MOV     C,M
        LDAX    B
MERGE3: CPI     0
        JC      MERGE5
        JNZ     MERGE6
        INR     B
        LDAX    B
        MVI     B,K0P
MERGE4: CPI     0
        JC      MERGE5
        JNZ     MERGE6
        CALL    LOWCMP
        JNC     MERGE6
MERGE5: MOV     A,C
        STAX    D
        INR     E
        INR     L
        JNZ     MERGE2
MERGE6: LDA     CUR+1
        STAX    D
        INR     E
        LDA     NEW
        INR     A
        STA     NEW
        JNZ     MERGE1
        RET

; Keys and order of the pieces of the list in page H, whose first place is A.
KEYORD: MOV     L,A
        PUSH    H
        CALL    KEYS
        POP     H
        JMP     ORDER

; The order without the pieces that have turned away. What is behind the last of them stays where it is.
REMOVE: LXI     H,LIST+0FFH
        MVI     B,FACEP
REMOV1: MOV     C,M
        LDAX    B
        DCR     L
        ORA     A
        JNZ     REMOV1
        MOV     D,H
        MOV     E,L
        INR     E
REMOV2: MOV     C,M
        LDAX    B
        DCR     L
        ORA     A
        JZ      REMOV3
        MOV     A,C
        STAX    D
        DCR     E
        JMP     REMOV2
REMOV3: MOV     A,C             ; another, or the sentinel
        ORA     A
        JNZ     REMOV2
        STAX    D
        INR     E
        MOV     A,E
        STA     FIRST
        RET

; ---- The limits that the eye passes, or passes back, in every direction.
SIDES:  LDA     ORIGIN
        MOV     L,A
        MVI     H,K3P
        MOV     A,M
        STA     SIDE2+1
        DCR     H
        MOV     A,M
        STA     SIDE3+1
        DCR     H
        MOV     A,M
        STA     SIDE4+1
        DCR     H
        MOV     A,M
        STA     SIDE5+1
        LXI     H,REACHED
        SHLD    SIDEP
        LDA     ORIGIN
SIDE1:  INR     A
        STA     DIRS
        MOV     L,A
        MVI     H,K3P
SIDE2:  MVI     A,0             ; the key of the origin less that of the direction's point
        SUB     M
        MOV     E,A
        DCR     H
SIDE3:  MVI     A,0
        SBB     M
        MOV     D,A
        DCR     H
SIDE4:  MVI     A,0
        SBB     M
        MOV     C,A
        DCR     H
SIDE5:  MVI     A,0
        SBB     M
        ADI     80H
        MOV     B,A
        LHLD    SIDEP
        MOV     A,M
        INX     H
        MOV     H,M
        MOV     L,A
; Mostly the first bytes decide.
        MOV     A,M
        CMP     B
        JC      SIDE7
        JZ      SIDE7
        DCX     H
        DCX     H
        DCX     H
        DCX     H
        DCX     H
        MOV     A,M
        CMP     B
        JNC     SIDE8
SIDE6:  LHLD    SIDEP
        INX     H
        INX     H
        SHLD    SIDEP
        LDA     TOTAL
        MOV     B,A
        LDA     DIRS
        CMP     B
        JNZ     SIDE1
        RET

SIDE7:  PUSH    H
        CALL    COMPAR
        POP     H
        JNC     SIDE9
        CALL    TURN
        JMP     SIDE7
SIDE8:  PUSH    H               ; the entry before
        CALL    COMPAR
        POP     H
        JC      SIDE10
        PUSH    H
        CALL    TURN
        POP     H
        JZ      SIDE10
SIDE9:  DCX     H
        DCX     H
        DCX     H
        DCX     H
        DCX     H
        JMP     SIDE8
SIDE10: CALL    NEXTEN
        XCHG
        LHLD    SIDEP
        MOV     M,E
        INX     H
        MOV     M,D
        JMP     SIDE6

; The piece of the entry at HL turns, and HL goes to the next entry. Zero if it is a sentinel. B to E are kept.
TURN:   INX     H
        INX     H
        INX     H
        INX     H
        MOV     A,M
        INX     H
        ORA     A
        RZ
        PUSH    H
        PUSH    D
        MOV     E,A
        MVI     D,FACEP
        LDAX    D
        XRI     1
        STAX    D
        MVI     H,NEWP
        JNZ     TURN1
        MVI     H,AWAYP
TURN1:  MVI     L,0
        DCR     M
        MOV     L,M
        MOV     M,E
        POP     D
        POP     H
        ORI     1
        RET

; ---- Pieces that have turned away get the priority 0. Zero if no piece faces the eye.
LOADA:  LXI     H,AWAY
        MOV     A,M
        ORA     A
        JZ      LOADA2
        MOV     L,A
LOADA1: MOV     A,M
        OUT     PDNUM
        XRA     A
        OUT     PDPRI
        INR     L
        JNZ     LOADA1
LOADA2: LDA     FIRST
        ORA     A
        RET

SIDEP:  DW      0               ; a place in REACHED
DIRS:   DB      0               ; directions left, or the number of one's point
LEFTE:  DB      0               ; entries left
