; The shaded surface (the paper's algorithm 4.2): Gouraud along the slice and down to the slice before it.

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
        CALL    SHENG
        LDA     SURN
        DCR     A
        JZ      SHDONE          ; one vertex is no line
        LDA     FRESH
        ORA     A
        JZ      SURFG
        LDA     QUICK
        ORA     A
        JZ      SURFG
        CALL    FIRST
        JMP     SNEXT
SURFG:  LXI     H,SURN          ; a line by the step engine
        DCR     M
        JZ      SHDONE
        POP     D
        DCX     SP
        POP     PSW
        CALL    SHLINE
        JNC     SURFG
        LDA     QUICK
        ORA     A
        JZ      SURFG
        JMP     SNEXT

; RIM x y i.
RIM:    CALL    SHENG
        POP     D
        DCX     SP
        POP     PSW
        MOV     C,A
        LDA     FRESH
        ORA     A
        JZ      RIM1
        MOV     A,C             ; the first vertex of a chain: a line of length nothing steps it
        ANI     7
        STA     LEV
        PUSH    D
        PUSH    B
        CALL    MOVETO
        POP     B
        POP     D
RIM1:   MVI     A,1
        STA     NOFILL
        MOV     A,C
        CALL    SHLINE
SHDONE: LDA     COLR
        CALL    INK
        JMP     NEXT

; The engine's steps are shades; the first point is shaded at the level of the pen.
SHENG:  LHLD    SSTEP
        SHLD    GSTEP+1
        LHLD    SFIRST
        SHLD    FSTEP+1
        RET

; Line to E = x, D = y, level A there, by the engine. Carry unless it has no length.
SHLINE: ANI     7
        STA     LEVEND
        CALL    FIRST
        CALL    GSET
        JZ      SHLIN1
        CALL    SHSET
        CALL    GLOOP
        STC
SHLIN1: LDA     LEVEND
        STA     LEV
        RET

; Prepare the level's way along a line of length E. Changes A, H.
SHSET:  MOV     A,E
        STA     SHLEN+1
        XRA     A
        SUB     E
        RAR
        STA     SHERR
        LDA     LEV
        MOV     H,A
        LDA     LEVEND
        SUB     H
        MVI     H,INRA
        JNC     SHSET1
        CMA
        INR     A
        MVI     H,DCRA
SHSET1: STA     SHDEL+1
        STA     SXDEL+1
        STA     SYDEL+1
        MOV     A,H
        STA     SHINC
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
SHLEV:  LDA     SHERR
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
        CALL    SHPLO2
        JMP     FILL
