; Start, receipt of the model, the loop of frames, the end.

        ORG     0
        JMP     START
STATUS: DB      0               ; 0 running, else why it stopped
PREC:   DB      0               ; precision 1, 2, 3
AXES:   DB      0
COUNT:  DB      0               ; N
PLANES: DB      0               ; D
TOTAL:  DB      0               ; points: N + 2 D, with the facing test M + 1 more
FIRST:  DB      0               ; low byte of the order's first place: 256 less its pieces
SUMS:   DW      0               ; s, t between packets
EYE:    DS      6
        IF      FACING
MDIRS:  DB      0               ; M, directions
ORIGIN: DB      0               ; number of the point from which they go: N + 2 D + 1
        ENDIF

START:  DI
        LXI     SP,STACK
        XRA     A
        STA     STATUS
        MVI     A,PARMOD
        OUT     PARCTL
        IN      PDCTL
        INR     A
        MVI     B,ABSENT
        JZ      STOP
        CALL    SQUARE

; ---- The model. D = t, E = s throughout receipt.
        LXI     D,0
        MVI     B,NOTFL
        CALL    GETB
        CPI     'F'
        JNZ     STOP
        CALL    GETB
        IF      FACING
        CPI     'F'
        ELSE
        CPI     'L'
        ENDIF
        JNZ     STOP
        MVI     B,RANGE
        CALL    GETB
        STA     PREC
        DCR     A
        CPI     3
        JNC     STOP
        CALL    GETB
        STA     AXES
        SUI     2
        CPI     2
        JNC     STOP
        CALL    GETB
        STA     COUNT
        ORA     A
        JZ      STOP
        MOV     H,A
        CMA
        INR     A
        STA     FIRST
        CALL    GETB
        STA     PLANES
        CPI     127
        JNC     STOP
        ADD     A
        ADD     H
        JC      STOP
        IF      FACING
        INR     A
        JZ      STOP
        STA     ORIGIN
        MOV     H,A
        CALL    GETB
        STA     MDIRS
        ORA     A
        JZ      STOP
        ADD     H
        JC      STOP
        ENDIF
        STA     TOTAL
        LDA     PREC
        DCR     A
        JNZ     PWORDS

; Points of bytes: L = number, from N down.
        LDA     TOTAL
        MOV     L,A
PBYTE1: MVI     H,XBP
        LDA     AXES
        MOV     C,A
PBYTE2: CALL    GETB
        MOV     M,A
        INR     H
        DCR     C
        JNZ     PBYTE2
        DCR     L
        JNZ     PBYTE1
        JMP     PDONE

; Points of words, piece N at the highest address.
PWORDS: LDA     AXES
        ADD     A
        MOV     C,A             ; bytes of a point
        LDA     TOTAL
        MOV     B,A
        LXI     H,POINTS
PWORD1: MOV     A,C
        CALL    ADDHL
        DCR     B
        JNZ     PWORD1
        LDA     TOTAL
        MOV     B,A
PWORD2: MOV     A,C             ; back by one point
        CMA
        INR     A
        DCR     H
        CALL    ADDHL
        PUSH    B
        CALL    GETPT
        POP     B
        MOV     A,C             ; and again: GETPT has passed it
        CMA
        INR     A
        DCR     H
        CALL    ADDHL
        DCR     B
        JNZ     PWORD2

PDONE:  LDA     PLANES
        ORA     A
        CNZ     GETCEL
        IF      FACING
        CALL    GETENT
        ENDIF
        MVI     B,BADPCS
        CALL    GETCHK
        PUSH    D
        CALL    INIT
        POP     D

; ---- A packet
FRAME:  MVI     B,UNKNWN
        CALL    GETB
        ORA     A
        JZ      ENDED
        CPI     1
        JNZ     STOP
        LXI     H,EYE
        LDA     PREC
        DCR     A
        JNZ     EWORDS
        LDA     AXES
        MOV     C,A
EBYTE:  CALL    GETB
        MOV     M,A
        INX     H
        DCR     C
        JNZ     EBYTE
        JMP     EDONE
EWORDS: CALL    GETPT
EDONE:  MVI     B,BADPKT
        CALL    GETCHK
        XCHG
        SHLD    SUMS
        IF      FACING
        CALL    FACES
        ELSE
        CALL    KEYS            ; the routine of the precision
        CALL    ORDER
        ENDIF
        LDA     PLANES
        ORA     A
        CNZ     RANKS
LOADW:  IN      PDCTL
        ANI     PDWAIT
        JNZ     LOADW
LOADED: CALL    LOAD
        MVI     A,PDSHOW
        OUT     PDCTL
SHOWN:  LHLD    SUMS
        XCHG
        JMP     FRAME

ENDED:  MVI     B,BADPKT
        CALL    GETCHK
        MVI     B,COMPLT
; ---- The end. B = status.
STOP:   MOV     A,B
        STA     STATUS
        DI
        HLT
        JMP     STOP

KEYS:   JMP     0               ; put there by INIT

; ---- Receipt
; Stores a point of words at HL; with precision 2 each is checked, and stored times four. Advances HL.
GETPT:  LDA     AXES
        MOV     C,A
GETPT1: CALL    GETB
        MOV     M,A
        INX     H
        CALL    GETB
        MOV     M,A
        LDA     PREC
        CPI     2
        JNZ     GETPT2
        MOV     A,M
        CPI     10H
        MVI     B,RANGE
        JNC     STOP
        DCX     H
        PUSH    D
        MOV     E,M
        MOV     D,A
        XCHG
        DAD     H
        DAD     H
        XCHG
        MOV     M,E
        INX     H
        MOV     M,D
        POP     D
GETPT2: INX     H
        DCR     C
        JNZ     GETPT1
        RET

; Both check bytes must be E = s, D = t; else B is the status.
GETCHK: CALL    GETRAW
        CMP     E
        JNZ     STOP
        CALL    GETRAW
        CMP     D
        JNZ     STOP
        RET

; The next byte into A, and into the sums.
GETB:   IN      PARSTA
        ANI     PARIBF
        CZ      GETWT
        IN      PARDAT
        PUSH    PSW
        ADD     E
        MOV     E,A
        ADD     D
        MOV     D,A
        POP     PSW
        RET
GETRAW: IN      PARSTA
        ANI     PARIBF
        CZ      GETWT
        IN      PARDAT
        RET
GETWT:  PUSH    H
        LXI     H,0
GETWT1: IN      PARSTA
        ANI     PARIBF
        JNZ     GETWT2
        DCX     H
        MOV     A,H
        ORA     L
        JNZ     GETWT1
        MVI     B,SILENT
        JMP     STOP
GETWT2: POP     H
        RET

; HL + A, A from 0 to 255.
ADDHL:  ADD     L
        MOV     L,A
        RNC
        INR     H
        RET

; ---- Once for a model: the order, the sentinel, the routine of the keys and its table.
INIT:   LXI     H,K0
        MVI     B,4             ; keys that have fewer bytes end with zeros; number 0 has the key 0
        XRA     A
INIT1:  MOV     M,A
        INR     L
        JNZ     INIT1
        INR     H
        DCR     B
        JNZ     INIT1
        IF      FACING
        CALL    BEGIN
        ELSE
        LDA     FIRST
        MOV     L,A
        MVI     H,LISTP
        DCR     L
        MVI     B,0
INIT2:  MOV     M,B             ; 0 before the first place, then 1, 2 ... N
        INR     B
        INR     L
        JNZ     INIT2
        ENDIF
        LXI     H,ORDER2
        SHLD    SAMELO+1
        LXI     H,PUT
        SHLD    SHIFLO+1
        LDA     PREC
        DCR     A
        JZ      INITB
        LXI     H,LOWER
        SHLD    SAMELO+1
        LXI     H,SHIFT1
        SHLD    SHIFLO+1
        DCR     A
        JZ      INITT
        LXI     H,KEYW2
        LDA     AXES
        CPI     2
        JZ      INIT3
        LXI     H,KEYW3
        JMP     INIT3
INITB:  LXI     H,KEYB2
        LDA     AXES
        CPI     2
        JZ      INIT3
        LXI     H,KEYB3
        JMP     INIT3
INITT:  CALL    TABLE
        LXI     H,KEYT2
        LDA     AXES
        CPI     2
        JZ      INIT3
        LXI     H,KEYT3
INIT3:  SHLD    KEYS+1
        RET

; ---- Squares of 0..255: each is the one before and the odd number between them.
SQUARE: LXI     H,0             ; the square
        LXI     D,1             ; the odd number
        LXI     B,SQL
SQUAR1: MOV     A,L
        STAX    B
        INR     B
        MOV     A,H
        STAX    B
        DCR     B
        DAD     D
        INX     D
        INX     D
        INR     C
        JNZ     SQUAR1
        RET
