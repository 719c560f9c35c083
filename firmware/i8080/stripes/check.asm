; The body: every record is looked at byte by byte, so that what follows cannot leave its memory, and the extents of the faces
; are found. Source: SPECIFICATION.md, section 1.

RECP:   DW      0               ; the record
RECEND: DW      0               ; after it
EXTP:   DW      0               ; the face's entry of EXT
AXISP:  DW      0               ; in it, the axis at hand

RECS:   LXI     H,SCENE
        SHLD    RECP
RECS1:  LDA     FACE
        LXI     H,COUNT
        CMP     M
        JZ      RECS9
        MOV     L,A             ; the entry: everything less than nothing
        MVI     H,0
        DAD     H
        XCHG
        LXI     H,FACEP
        DAD     D
        XCHG
        LHLD    RECP
        XCHG
        MOV     M,E
        INX     H
        MOV     M,D
        LDA     FACE
        CALL    EXTOF
        SHLD    EXTP
        MVI     C,3
RECS2:  MVI     M,255
        INX     H
        MVI     M,255
        INX     H
        MVI     M,0
        INX     H
        MVI     M,0
        INX     H
        DCR     C
        JNZ     RECS2
        LHLD    BODYE
        SHLD    RECEND
        LHLD    RECP
        CALL    NB
        MOV     C,A
        CALL    NB
        MOV     B,A
        PUSH    H
        LHLD    RECP
        DAD     B
        JC      BAD
        XCHG                    ; DE = its end
        LHLD    BODYE
        MOV     A,L
        SUB     E
        MOV     A,H
        SBB     D
        JC      BAD
        XCHG
        SHLD    RECEND
        POP     H
        CALL    NB              ; level
        DCR     A
        CPI     7
        JNC     BAD
        LDA     MODE
        ANI     STRIPE OR PRIOR
        CPI     STRIPE
        CNZ     POLYG
        LDA     MODE
        ANI     STRIPE
        CNZ     LISTS
        XCHG                    ; the record ends here
        LHLD    RECEND
        MOV     A,E
        CMP     L
        JNZ     BAD
        MOV     A,D
        CMP     H
        JNZ     BAD
        SHLD    RECP
        LXI     H,FACE
        INR     M
        JMP     RECS1
RECS9:  LHLD    RECP            ; and the body with the last record
        XCHG
        LHLD    BODYE
        MOV     A,L
        CMP     E
        JNZ     BAD
        MOV     A,H
        CMP     D
        RZ
BAD:    MVI     B,BADREC
        JMP     STOP

; Next byte of the record at HL. Keeps BC, DE.
NB:     PUSH    D
        XCHG
        LHLD    RECEND
        MOV     A,E
        SUB     L
        MOV     A,D
        SBB     H
        XCHG
        POP     D
        JNC     BAD
        MOV     A,M
        INX     H
        RET

; Plane and rings.
POLYG:  MVI     C,4
        CALL    SKIP
        CALL    NB
        MOV     B,A
        CALL    NB
        ORA     A
        JM      BAD
        ORA     B
        JZ      BAD             ; c is 0
        MVI     C,4
        CALL    SKIP
        CALL    SHAPE
        CALL    NB
        ORA     A
        JZ      BAD
        MOV     C,A             ; rings
POLYG1: CALL    NB
        CPI     3
        JC      BAD
        MOV     B,A             ; vertices
POLYG2: XCHG
        LHLD    EXTP
        SHLD    AXISP
        XCHG
        CALL    AXIS
        CALL    AXIS
        CALL    AXIS
        DCR     B
        JNZ     POLYG2
        DCR     C
        JNZ     POLYG1
        PUSH    H               ; lines of the least and the greatest Y
        LHLD    EXTP
        LXI     D,4
        DAD     D
        CALL    LINEOF
        MOV     B,A
        CALL    LINEOF
        MOV     C,A
        LXI     D,ELINES-8
        DAD     D
        MOV     M,B
        INX     H
        MOV     M,C
        POP     H
        RET

; The line of the Y at HL; advances HL past it.
LINEOF: MOV     A,M
        ADI     80H
        INX     H
        MOV     A,M
        ACI     0
        INX     H
        RET

SKIP:   CALL    NB
        DCR     C
        JNZ     SKIP
        RET

; HL is where the shape begins. Changes BC, DE.
SHAPE:  XCHG
        LHLD    EXTP
        LXI     B,ELINES+2
        DAD     B
        MOV     M,E
        INX     H
        MOV     M,D
        XCHG
        RET

; A coordinate: not above FF00, and into the extent.
AXIS:   CALL    NB
        MOV     E,A
        CALL    NB
        MOV     D,A
        INR     A
        JNZ     AXIS1
        ORA     E
        JNZ     BAD
AXIS1:  PUSH    H
        LHLD    AXISP
        MOV     A,E
        SUB     M
        INX     H
        MOV     A,D
        SBB     M
        JNC     AXIS2
        MOV     M,D
        DCX     H
        MOV     M,E
        INX     H
AXIS2:  INX     H
        MOV     A,M
        SUB     E
        INX     H
        MOV     A,M
        SBB     D
        JNC     AXIS3
        MOV     M,D
        DCX     H
        MOV     M,E
        INX     H
AXIS3:  INX     H
        SHLD    AXISP
        POP     H
        RET

; Lists of toggles, line by line.
LISTS:  CALL    NB
        MOV     B,A             ; lowest line
        CALL    NB
        MOV     C,A             ; lines
        ADD     B
        JC      BAD
        MOV     D,A
        PUSH    H
        LHLD    EXTP
        MOV     A,L
        ADI     ELINES          ; entries do not cross a page
        MOV     L,A
        MOV     M,B
        INX     H
        MOV     M,D
        POP     H
        PUSH    B
        CALL    SHAPE
        POP     B
        MOV     A,C
        ORA     A
        RZ
        MOV     B,A
LIST1:  MVI     C,16
        CALL    NB
LIST2:  MOV     E,A
        INR     A
        JZ      LIST3
        DCR     C
        JZ      BAD
        CALL    NB
        CMP     E
        JC      BAD
        JZ      BAD
        JMP     LIST2
LIST3:  DCR     B
        JNZ     LIST1
        RET
