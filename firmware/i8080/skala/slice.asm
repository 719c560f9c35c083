; A shaded slice on the EF9365 board with visibility, without silhouettes: lines with loops of their own. All other cases go
; through the step engine (surface.asm) and draw the same.
;
; Between two lines L = xp, B = yp. After a line along y (SNEXT) the pen's column is pending and shaded; at the end of one
; along x (SXEND) it is not even tested, so that it can be done in one if the next line leaves it at once.

SNEXT:  MOV     C,L
        LXI     H,SURN
        DCR     M
        MOV     L,C
        JZ      SEND
        POP     D
        DCX     SP
        POP     PSW
        ANI     7
        STA     LEVEND
        CALL    GDIR
        JZ      SZERO
        JC      SNEXTY
        CALL    SXSET
        CALL    FOLD
        JMP     SX
SZERO:  LDA     LEVEND          ; a new level at the same point, where it is not yet shaded
        STA     LEV
        MOV     H,B
        SHLD    XYP
        JMP     SURFG
SEND:   MOV     H,B
        SHLD    XYP
        JMP     SHDONE

SXEND:  MOV     C,L
        LXI     H,SURN
        DCR     M
        MOV     L,C
        JZ      SXEND3
        POP     D
        DCX     SP
        POP     PSW
        ANI     7
        STA     LEVEND
        CALL    GDIR
        JZ      SXEND2
        JC      SXEND1
        CALL    SXSET
        JMP     SXTEST
SXEND1: CALL    SYSET
        CALL    SXPEND
        JMP     SY
SXEND2: CALL    SXPEND
        JMP     SZERO
SXEND3: CALL    SXPEND
        JMP     SEND

; The last column of a line along x becomes pending.
SXPEND: MVI     A,1
        STA     SHFRSH
        JMP     SHADEF

; ---- Along x a column is entered once: tested, filled, folded and kept in one.
SXSET:  STA     SXDX
        MOV     A,H
        STA     SXDY
        MOV     A,E
        STA     SXSUB+1
        JMP     SHSET

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
SXLEV:  MVI     M,0
LEV     EQU     SXLEV+1         ; level at the pen
SX:     MOV     A,C
        ADD     D
        JNC     SX1
SXSUB:  SUI     0
SXDY:   INR     B
SX1:    MOV     C,A
SXDX:   INR     L
SXERR:  MVI     A,0
SHERR   EQU     SXERR+1         ; the level's error along the line
SXDEL:  ADI     0
        JC      SX4
        STA     SHERR
SX2:    DCR     E
        JNZ     SXTEST
        JMP     SXEND
SX4:    CALL    SHLEV1
        JMP     SX2

SXABOV: LDA     LEV
        CALL    SDOT
        CNZ     FILLTO
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
SXBELO: LDA     LEV
        CALL    SDOT
        CNZ     FILL
        MVI     H,MBP
        MOV     M,B
        JMP     SXKEEP

; The dot of a column just entered: NZ when there is something to fill towards. SDOTY: column and colour are set.
SDOT:   OUT     GDPCOL
        MOV     A,L
        OUT     GDPX
SDOTY:  MOV     A,B
        OUT     GDPY
        MVI     A,DOT
        OUT     GDPCMD
        MVI     H,IPP
        MOV     A,M
        ORA     A
        RET

; ---- Along y: a fill where a column is entered; its last row is what the next slice finds. The first column is the pending
; one; of the others only the row they are entered at is kept, and they are folded when they are left. The colour latch
; holds LEV.
SYSET:  STA     SYDX
        MOV     A,H
        STA     SYB1
        STA     SYB2
        CPI     INRB
        PUSH    H
        LXI     H,4FH           ; MOV C,A; NOP
        JZ      SYSET1
        LXI     H,4748H         ; MOV C,B; MOV B,A
SYSET1: SHLD    SYSORT
        POP     H
        MOV     A,E
        STA     SYSUB+1
        RET

SNEXTY: CALL    SYSET
SY:     CALL    SHSET
        LDA     LEV
        OUT     GDPCOL
        MOV     A,L
        OUT     GDPX
        LXI     H,SYFOL0
        SHLD    SYFOLD+1
        MOV     L,A
SY1:    MOV     A,C
        ADD     D
        JC      SYNEW
        MOV     C,A
SYB1:   INR     B
        LDA     SHERR
SYDEL:  ADI     0
        JC      SYLEV
        STA     SHERR
SYTEST: MVI     H,MTP
        MOV     A,M
        CMP     B
        JC      SY2
        INR     H
        MOV     A,B
        CMP     M
        JNC     SY3
SY2:    MOV     A,B
        OUT     GDPY
        MVI     A,DOT
        OUT     GDPCMD
SY3:    DCR     E
        JNZ     SY1
SYEND:  LDA     SYFOLD+1
        CPI     LOW SYFOL0
        JZ      SYEND1
        MOV     A,L             ; the last column becomes pending
        STA     PX
        LDA     SYROW+1
        STA     PLO
        STA     PHI
SYEND1: CALL    SHKEEP
        CALL    TOUCHS
        JMP     SNEXT

SYLEV:  CALL    SHLEV1
        LDA     LEV
        OUT     GDPCOL
        JMP     SYTEST

SYNEW:
SYSUB:  SUI     0
        MOV     C,A
        MVI     H,MPP
        MOV     M,B
        INR     H
        LDA     LEV
        MOV     M,A
SYFOLD: CALL    SYFOL0
SYB2:   INR     B
SYDX:   INR     L
        MOV     A,B
        STA     SYROW+1
        MOV     A,L
        OUT     GDPX
        CALL    SHLEV
        LDA     LEV
        OUT     GDPCOL
        MVI     H,MTP
        MOV     A,M
        CMP     B
        JC      SYNEW1
        INR     H
        MOV     A,B
        CMP     M
        JNC     SY3
        CALL    SDOTY
        CNZ     FILL
        JMP     SYNEW2
SYNEW1: CALL    SDOTY
        CNZ     FILLTO
SYNEW2: LDA     LEV
        OUT     GDPCOL
        JMP     SY3

; Fold the column that is left: the pending one; the others.
SYFOL0: CALL    TOUCHS
        CALL    FOLD
        PUSH    H
        LXI     H,SYFOL1
        SHLD    SYFOLD+1
        POP     H
        RET
SYFOL1: PUSH    B
SYROW:  MVI     A,0             ; the row it was entered at
SYSORT: MOV     C,A             ; B = highest, C = lowest
        NOP
        MVI     H,MTP
        CALL    FOLDK
        POP     B
        RET
