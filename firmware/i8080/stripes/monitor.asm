; The monitor: start, receipt of the stream, the order of the work, the end.

        ORG     0
        JMP     START
STATUS: DB      0               ; 0 running, else why it stopped
FAULT:  DB      0               ; the face at fault
MODE:   DB      0
COUNT:  DB      0               ; faces
FACE:   DB      0               ; the one at hand
SUM1:   DB      0
SUM2:   DB      0
BODYE:  DW      0               ; behind the body

START:  DI
        LXI     SP,STACK
        MVI     A,PARMOD
        OUT     PARCTL
        LXI     H,0
        SHLD    SUM1            ; and SUM2
        SHLD    STATUS          ; and FAULT
        XRA     A
        STA     FACE
        CALL    GETB
        CPI     53H
        MVI     B,NOTSTR
        JNZ     STOP
        CALL    GETB
        CPI     1
        JNZ     STOP
        CALL    GETB
        MOV     C,A
        CALL    GETB
        MOV     B,A             ; BC = length of the body
        LXI     H,SCNMAX
        MOV     A,L
        SUB     C
        MOV     A,H
        SBB     B
        JC      BIG
        LXI     H,SCENE
        DAD     B
        SHLD    BODYE
        CALL    GETB
        CPI     8
        JNC     NOSTRM
        STA     MODE
        IF      COVER
        ANI     VECTOR+STRIPE
        JNZ     NOSTRM
        STA     LAYERS          ; the priority list needs plain stripes
        ENDIF
        IF      OVERW
        ANI     VECTOR
        JNZ     NOSTRM
        ENDIF
        CALL    GETB
        CPI     MOSTF+1
        JNC     BIG
        STA     COUNT
        LXI     H,SCENE
RECV1:  MOV     A,B
        ORA     C
        JZ      RECV2
        CALL    GETB
        MOV     M,A
        INX     H
        DCX     B
        JMP     RECV1
RECV2:  LHLD    SUM1            ; L = s1, H = s2
        CALL    GETB
        CMP     L
        MVI     B,BADSUM
        JNZ     STOP
        CALL    GETB
        CMP     H
        JNZ     STOP
        ; fall into the work

CHECK:  CALL    RECS
        XRA     A
        STA     FACE
        CALL    DEVON
        ; The priority list: found, or the order of the stream.
RANKIT: XRA     A
        STA     NCUT
        LDA     MODE
        ANI     PRIOR
        JNZ     WORK1
        LXI     H,ORDER
        LDA     COUNT
        MOV     C,A
        XRA     A
WORK0:  CMP     C
        JZ      DRAWIT
        MOV     M,A
        INX     H
        INR     A
        JMP     WORK0
WORK1:  CALL    RANK
        IF      OVERW
        ; The faces, farthest first.
DRAWIT: LXI     H,ORDER
        LDA     COUNT
        MOV     E,A
        MVI     D,0
        DAD     D
WORK3:  MOV     A,L
        CPI     LOW ORDER
        JZ      WORK4
        DCX     H
        MOV     A,M
        PUSH    H
        CALL    DRAW
        POP     H
        JMP     WORK3
        ELSE
        ; The faces, nearest first.
DRAWIT: LXI     H,SS
        IF      COVER
        LXI     D,96
        MVI     A,1
        STA     LAYERS
        ELSE
        LXI     D,32
        ENDIF
        MVI     C,255
WORK2:  MVI     M,255
        DAD     D
        DCR     C
        JNZ     WORK2
        LXI     H,ORDER
WORK3:  LXI     D,COUNT
        LDAX    D
        ADI     LOW ORDER
        CMP     L
        JZ      WORK4
        MOV     A,M
        PUSH    H
        CALL    DRAW
        POP     H
        INX     H
        JMP     WORK3
        ENDIF
WORK4:
        IF      COVER
        CALL    REST
        ENDIF
        IF      PLOTS
        LDA     MODE
        ANI     VECTOR
        CNZ     PENUP
        ENDIF
        MVI     B,COMPLT
        JMP     STOP

NOSTRM: MVI     B,NOTSTR
        JMP     STOP
BIG:    MVI     B,TOOBIG
        JMP     STOP
OVERF:  MVI     B,FULL
        ; fall into the end

; ---- The end. B = status.
STOP:   LXI     SP,STACK
        MOV     A,B
        STA     STATUS
        SUI     BADREC
        CPI     2               ; BADREC or FULL: of a face
        JNC     STOP1
        LDA     FACE
        STA     FAULT
STOP1:  DI
        HLT
        JMP     STOP1

; Next byte from the host into A and into the check sums. Changes DE.
GETB:   LXI     D,0             ; 65,536 looks of 51 T-states: 1.1 s at 3 MHz
GETB1:  IN      PARSTA
        ANI     PARIBF
        JNZ     GETB2
        DCX     D
        MOV     A,D
        ORA     E
        JNZ     GETB1
        MVI     B,SILENT
        JMP     STOP
GETB2:  IN      PARDAT
        MOV     E,A
        LDA     SUM1
        ADD     E
        STA     SUM1
        MOV     D,A
        LDA     SUM2
        ADD     D
        STA     SUM2
        MOV     A,E
        RET
