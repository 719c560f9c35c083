; The shaded surface (the paper's algorithm 4.2): Gouraud along the slice and down to the slice before it.

LEV:    DB      0               ; level at the pen
LEVEND: DB      0               ; level at the end of the line
SHX:    DB      0               ; column of the last shade
SHFRSH: DB      1               ; not 0: a new chain of shades
NOFILL: DB      0               ; not 0: a rim
SURN:   DB      0

; SURFACE n, n times x y i.
SURF:   XRA     A
        STA     NOFILL
        DCX     SP
        POP     PSW
        STA     SURN
        POP     D
        CALL    MOVETO
        DCX     SP
        POP     PSW
        ANI     7
        STA     LEV
SURF1:  LDA     SURN
        DCR     A
        JZ      SHDONE
        STA     SURN
        POP     D
        DCX     SP
        POP     PSW
        CALL    SHLINE
        JMP     SURF1

; RIM x y i.
RIM:    POP     D
        DCX     SP
        POP     PSW
        MOV     C,A
        LDA     FRESH
        ORA     A
        MOV     A,C
        JNZ     RIM1
        MVI     A,1
        STA     NOFILL
        MOV     A,C
        CALL    SHLINE
SHDONE: LDA     COLR
        CALL    INK
        JMP     NEXT
RIM1:   ANI     7
        STA     LEV
        CALL    MOVETO
        JMP     NEXT

; Line to E = x, D = y, level A there.
SHLINE: ANI     7
        STA     LEVEND
        LHLD    SSTEP
        SHLD    GSTEP+1
        LHLD    SFIRST          ; the first point is shaded at the level of the pen
        SHLD    FSTEP+1
        CALL    FIRST
        CALL    GSET
        JZ      SHLIN3
        MOV     A,E
        STA     SHLEN+1
        PUSH    B
        XRA     A
        SUB     E
        RAR
        STA     SHERR
        LDA     LEV
        MOV     B,A
        LDA     LEVEND
        SUB     B
        MVI     B,INRA
        JNC     SHLIN1
        CMA
        INR     A
        MVI     B,DCRA
SHLIN1: STA     SHDEL+1
        MOV     A,B
        STA     SHINC
        POP     B
        CALL    GLOOP
SHLIN3: LDA     LEVEND
        STA     LEV
        RET

; GAP x n: no previous slice there.
GAP:    POP     D
        MOV     L,E
        MVI     H,IPP
GAP1:   MVI     M,0
        INR     L
        DCR     D
        JNZ     GAP1
        JMP     NEXT

; ---- Steps of shading at (L, B). They keep L, BC, DE.
SHADE:  CALL    SHLEV
SHADEF: MVI     H,MTP
        MOV     A,M
        CMP     B
        JC      SHADE1
        INR     H
        MOV     A,B
        CMP     M
        JNC     SHADE2
SHADE1: CALL    SHPLOT
SHADE2: CALL    SHKEEP
        JMP     TOUCH

; Without visibility.
SHADEN: CALL    SHLEV
SHADNF: CALL    SHPLOT

; The point and its level are the slice's, for the next one.
SHKEEP: MVI     H,MPP
        MOV     M,B
        INR     H
        LDA     LEV
        MOV     M,A
        MOV     A,L
        STA     SHX
        XRA     A
        STA     SHFRSH
        RET

; The level's step along the line: a second error byte.
SHLEV:  MVI     A,0
SHERR   EQU     SHLEV+1
SHDEL:  ADI     0               ; levels in the line
        JNC     SHLEV2
SHLEV1: MOV     H,A
        LDA     LEV
SHINC:  INR     A
        STA     LEV
        MOV     A,H
SHLEN:  SUI     0               ; length
        JNC     SHLEV1
SHLEV2: STA     SHERR
        RET

; A visible point: with the column down to the slice before, when the chain has just come into it.
SHPLOT: LDA     SHFRSH
        ORA     A
        JNZ     SHPLO1
        LDA     SHX
        CMP     L
        JNZ     SHPLO1
SHPLO2: LDA     LEV
        CALL    INK
        JMP     PLOT
SHPLO1: LDA     NOFILL
        ORA     A
        JNZ     SHPLO2
        MVI     H,IPP
        MOV     A,M
        ORA     A
        JZ      SHPLO2

; Fill from (L, B), level LEV, towards the row of the slice before and its level A, as far as something can be seen:
; the row before is never outside the masks, so the fill ends at the nearer of mask and row.
FILL:   PUSH    B
        PUSH    D
        MOV     D,A
        MVI     H,MPP
        MOV     E,M
        LDA     LEV
        STA     FLEV
        CALL    INK
        CALL    PLOT
        LDA     FLEV
        MOV     C,A
        MOV     A,D
        SUB     C
        MVI     C,INRA
        JNC     FILL1
        CMA
        INR     A
        MVI     C,DCRA
FILL1:  MOV     D,A             ; D = levels
        MOV     A,C
        STA     FILLG4
        STA     FILLA4
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
FILLD2: MOV     H,A
        MOV     A,B
        SUB     H
        MOV     H,A
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
        MOV     H,A
        MVI     A,INRB
FILL3:  STA     FILLG1
        STA     FILLA1
        DCR     H               ; H = dots
        JZ      FILLX
        MOV     E,C
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
