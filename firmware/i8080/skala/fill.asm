; The fill of the shaded surface: from (L, B), which is plotted, level LEV, towards the row of the slice before and its
; level, as far as something can be seen. That row is never outside the masks once its column is folded, so the fill ends at
; the nearer of mask and row.

; FILLTO: on the EF9365 with visibility, for a dot above the top: nearly always downwards.
FILLTO: PUSH    B
        PUSH    D
        MVI     H,MPP
        MOV     E,M
        INR     H
        MOV     D,M             ; its level
        MOV     A,B
        SUB     E
        JC      FILL0
        JZ      FILLX
        MOV     C,A             ; C = N
        MVI     H,MTP
        MOV     A,M
        CMP     E
        JNC     FILLT1
        MOV     A,E
FILLT1: SUB     B
        CMA
        ORA     A
        JZ      FILLX
        MOV     H,A             ; H = dots
        LDA     LEV
        CMP     D
        JNZ     FILLT3
        MVI     C,DOT
FILLT2: DCR     B               ; one level all the way
        MOV     A,B
        OUT     GDPY
        MOV     A,C
        OUT     GDPCMD
        DCR     H
        JNZ     FILLT2
        POP     D
        POP     B
        RET
FILLT3: MVI     A,DCRB
        STA     FILLG1
        JMP     FILL4

FILL:   PUSH    B
        PUSH    D
FILL0:  MVI     H,MPP
        MOV     E,M
        MOV     A,B
        SUB     E
        JZ      FILLX
        JC      FILLU
        MOV     C,A             ; C = N
        LDA     VIS             ; downwards
        ORA     A
        JZ      FILLD1
        MVI     H,MTP
        MOV     A,M
        CMP     B
        JNC     FILLD1
        CMP     E
        JNC     FILLD2
FILLD1: MOV     A,E
FILLD2: SUB     B
        CMA
        MOV     H,A             ; H = dots
        MVI     A,DCRB
        JMP     FILL3
FILLU:  CMA                     ; upwards
        INR     A
        MOV     C,A
        LDA     VIS
        ORA     A
        JZ      FILLU1
        MVI     H,MBP
        MOV     A,B
        CMP     M
        JNC     FILLU1
        MOV     A,M
        CMP     E
        JC      FILLU2
FILLU1: MOV     A,E
FILLU2: SUB     B
        DCR     A
        MOV     H,A
        MVI     A,INRB
FILL3:  INR     H
        DCR     H
        JZ      FILLX
        STA     FILLG1
        STA     FILLA1
        MOV     E,H
        MVI     H,IPP
        MOV     D,M             ; its level
        MOV     H,E
FILL4:  MOV     E,C             ; E = N
        LDA     LEV
        STA     FLEV
        MOV     C,A
        MOV     A,D
        SUB     C
        JZ      FILLEQ
        MVI     C,INRA
        JNC     FILL1
        CMA
        INR     A
        MVI     C,DCRA
FILL1:  MOV     D,A             ; D = levels
        MOV     A,C
        STA     FILLG4
        STA     FILLA4
        XRA     A
        SUB     E
        RAR
        MOV     C,A
        LDA     DEV
        ORA     A
        JNZ     FILLA1
FILLG1: INR     B
        MOV     A,C
        ADD     D
        JC      FILLG3
FILLG2: MOV     C,A
        MOV     A,B
        OUT     GDPY
        MVI     A,DOT
        OUT     GDPCMD
        DCR     H
        JNZ     FILLG1
FILLX:  POP     D
        POP     B
        RET
; One level all the way.
FILLEQ: LDA     DEV
        ORA     A
        MVI     A,0
        JNZ     FILL1
        LDA     FILLG1
        STA     FILLF1
FILLF1: INR     B
        MOV     A,B
        OUT     GDPY
        MVI     A,DOT
        OUT     GDPCMD
        DCR     H
        JNZ     FILLF1
        JMP     FILLX

FILLG3: MOV     C,A
        LDA     FLEV
FILLG4: INR     A
        STA     FLEV
        OUT     GDPCOL
        MOV     A,C
        SUB     E
        JNC     FILLG3
        JMP     FILLG2

FILLA1: INR     B               ; on the other board
        MOV     A,C
        ADD     D
        JC      FILLA3
FILLA2: MOV     C,A
        CALL    PLOT
        DCR     H
        JNZ     FILLA1
        JMP     FILLX
FILLA3: MOV     C,A
        LDA     FLEV
FILLA4: INR     A
        STA     FLEV
        CALL    INK
        MOV     A,C
        SUB     E
        JNC     FILLA3
        JMP     FILLA2
FLEV:   DB      0               ; level of the fill
