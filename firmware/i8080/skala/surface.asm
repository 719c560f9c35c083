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
        CALL    SHRUN
SHLIN3: LDA     LEVEND
        STA     LEV
        RET

; The line with everything prepared: loops of its own on the EF9365 with visibility, when the pen's column is the pending
; and the last shaded one, as it nearly always is. All else step by step.
SHRUN:  LDA     NOFILL
        ORA     A
        JNZ     GLOOP
        LDA     QUICK
        ORA     A
        JZ      GLOOP
        LDA     PX
        CMP     L
        JNZ     GLOOP
        LDA     SHX
        CMP     L
        JNZ     GLOOP
        LDA     PLO
        CMP     B
        JZ      SHRUN1
        JNC     GLOOP
SHRUN1: LDA     PHI
        CMP     B
        JC      GLOOP
        LDA     GMAJ
        CPI     INRL
        JC      SY

; Along x a column is entered once: tested, filled, folded and kept in one, but for the last.
        STA     SXDX
        CALL    FOLD
        LDA     GMIN
        STA     SXDY
        MOV     A,E
        STA     SXSUB+1
        STA     SXLEN+1
        LDA     SHERR
        STA     SXERR+1
        LDA     SHDEL+1
        STA     SXDEL+1
        LDA     SHINC
        STA     SXINC
        LDA     LEV
        STA     SXLEV+1
        JMP     SX

SXTEST: MVI     H,MTP
        MOV     A,M
        CMP     B
        JC      SXABOV
        INR     H
        MOV     A,B
        CMP     M
        JC      SXBELO
SXKEEP: MVI     H,MPP
        MOV     M,B
        INR     H
SXLEV:  MVI     M,0             ; level
SX:     MOV     A,C
        ADD     D
        JNC     SX1
SXSUB:  SUI     0
SXDY:   INR     B
SX1:    MOV     C,A
SXDX:   INR     L
SXERR:  MVI     A,0
SXDEL:  ADI     0
        JC      SX4
SX2:    STA     SXERR+1
        DCR     E
        JNZ     SXTEST
        LDA     SXLEV+1
        STA     LEV
        CALL    SHADEF          ; the last column is left pending
        MOV     H,B
        SHLD    XYP
        RET

SX4:    MOV     H,A
        LDA     SXLEV+1
SXINC:  INR     A
        STA     SXLEV+1
        MOV     A,H
SXLEN:  SUI     0
        JNC     SX4
        JMP     SX2

SXABOV: CALL    SXDOT
        MVI     H,MTP
        MOV     A,M
        MOV     M,B
        ORA     A
        JNZ     SXKEEP
        INR     H
        MOV     A,M
        INR     A
        JNZ     SXKEEP
        MOV     M,B             ; unvisited
        JMP     SXKEEP

SXBELO: CALL    SXDOT
        MVI     H,MBP
        MOV     M,B
        JMP     SXKEEP

SXDOT:  LDA     SXLEV+1
        STA     LEV
SYDOT:  OUT     GDPCOL
        MOV     A,L
        OUT     GDPX
        MOV     A,B
        OUT     GDPY
        MVI     A,DOT
        OUT     GDPCMD
        MVI     H,IPP
        MOV     A,M
        ORA     A
        RZ
        JMP     FILL

; Along y: a fill where a column is entered; its last row is what the next slice finds.
SY:     MVI     H,IPP           ; a new level at the same point is not yet shaded
        LDA     LEV
        CMP     M
        JNZ     GLOOP
        LDA     GMAJ
        STA     SYB1
        STA     SYB2
        LDA     GMIN
        STA     SYDX
        MOV     A,E
        STA     SYSUB+1
        MOV     A,L
        OUT     GDPX
SY1:    MOV     A,C
        ADD     D
        JC      SYNEW
        MOV     C,A
SYB1:   INR     B
        CALL    SHLEV
        MVI     H,MTP
        MOV     A,M
        CMP     B
        JC      SY2
        INR     H
        MOV     A,B
        CMP     M
        JNC     SY3
SY2:    LDA     LEV
        OUT     GDPCOL
        MOV     A,B
        OUT     GDPY
        MVI     A,DOT
        OUT     GDPCMD
SY3:    DCR     E
        JNZ     SY1
SYEND:  CALL    SHKEEP
        CALL    TOUCHS
        MOV     H,B
        SHLD    XYP
        RET

SYNEW:
SYSUB:  SUI     0
        MOV     C,A
        MVI     H,MPP
        MOV     M,B
        INR     H
        LDA     LEV
        MOV     M,A
        CALL    TOUCHS
SYB2:   INR     B
SYDX:   INR     L
        MOV     A,L
        OUT     GDPX
        CALL    SHLEV
        MVI     H,MTP
        MOV     A,M
        CMP     B
        JC      SYNEW1
        INR     H
        MOV     A,B
        CMP     M
        JNC     SYNEW2
SYNEW1: LDA     LEV
        CALL    SYDOT
SYNEW2: CALL    TOUCHN
        DCR     E
        JNZ     SY1
        JMP     SYEND

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
        CALL    SHPLO2
        JMP     FILL
