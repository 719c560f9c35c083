; The step engine: one line of any mode on any device, a subroutine call a step. And what a step does to the masks.
;
; Registers in all loops of this program: L = x and H a page (so HL points to the column's entry in a mask), B = y,
; C = error byte, D = smaller delta, E = steps left. The error is kept as a negative byte, so that the carry of its
; addition is the minor step (the paper's d, halved: no sixteen-bit sums). The paper's NT, NB are the pending column.

TESTG:  POP     D
TESTX:  LHLD    TSTEP
        JMP     GLINES
DRAWG:  POP     D
        LHLD    DSTEP

; Line from the pen to E = x, D = y with the step routine HL.
GLINES: SHLD    GSTEP+1
        SHLD    FSTEP+1
        CALL    FIRST
; The same when the pen's point has been stepped and the engine has its routine.
GLINE:  CALL    GSET
        JZ      NEXT            ; no length
GRUN:   CALL    GLOOP
        JMP     NEXT

; The step routines for this device and visibility (SETMOD).
DSTEP:  DW      STEPD
TSTEP:  DW      STEPT
SSTEP:  DW      SHADE
SFIRST: DW      SHADEF
QUICK:  DB      1-ATONCE        ; the EF9365 with visibility, no silhouettes

; The first point of a chain. Keeps DE.
FIRST:  LDA     FRESH
        ORA     A
        RZ
        XRA     A
        STA     FRESH
        PUSH    D
        LHLD    XYP
        MOV     B,H
FSTEP:  CALL    STEPD
        POP     D
        RET

; The way from L = xp, B = yp to E = x, D = y: A and H = the instructions of a step along x and along y, E = length,
; D = smaller delta, C = error; Z when the line has no length, carry when it goes along y.
GDIR:   MOV     A,D
        SUB     B
        MVI     H,INRB
        JNC     GDIR1
        CMA
        INR     A
        MVI     H,DCRB
GDIR1:  MOV     D,A
        MOV     A,E
        SUB     L
        JC      GDIR3
        CMP     D
        JC      GDIR2
        MOV     E,A
        XRA     A               ; to the right: -((L+1)/2)
        SUB     E
        RZ
        RAR
        MOV     C,A
        MVI     A,INRL
        ORA     A
        RET
GDIR2:  MOV     E,D
        MOV     D,A
        XRA     A
        SUB     E
        RAR
        MOV     C,A
        MVI     A,INRL
        STC
        RET
GDIR3:  CMA
        INR     A
        CMP     D
        JC      GDIR4
        MOV     E,A
        CMA                     ; to the left: -(L/2+1)
        STC
        RAR
        MOV     C,A
        MVI     A,DCRL
        ORA     A               ; never without length
        RET
GDIR4:  MOV     E,D
        MOV     D,A
        MOV     A,E
        CMA
        STC
        RAR
        MOV     C,A
        MVI     A,DCRL
        ORA     A
        STC
        RET

; Prepare the engine for the line from the pen to E = x, D = y. Returns as GDIR, without the instructions.
GSET:   LHLD    XYP
        MOV     B,H
        CALL    GDIR
        RZ
        JC      GSET1
        STA     GMAJ
        MOV     A,H
        STA     GMIN
        MOV     A,E
        STA     GSUB+1
        RET
GSET1:  STA     GMIN
        MOV     A,H
        STA     GMAJ
        MOV     A,E
        STA     GSUB+1
        RET

; The loop. Ends with the pen at the line's end.
GLOOP:  MOV     A,C
        ADD     D
        JNC     GLOOP1
GSUB:   SUI     0               ; length
GMIN:   INR     B
GLOOP1: MOV     C,A
GMAJ:   INR     L
GSTEP:  CALL    STEPD
        DCR     E
        JNZ     GLOOP
        MOV     H,B
        SHLD    XYP
        RET

; ---- Steps at (L, B). They keep L, BC, DE.

; DRAW: test against the masks before this column, plot, remember.
STEPD:  MVI     H,MTP
        MOV     A,M
        CMP     B
        JC      STEPD1          ; above the top
        INR     H
        MOV     A,B
        CMP     M
        JNC     TOUCH
STEPD1: CALL    PLOT

; The point belongs to the pending column; a new column folds the one before.
        IF      ATONCE
TOUCH:  MOV     A,L             ; at once part of the masks
        STA     PX
        MOV     A,B
        STA     PLO
        STA     PHI
        JMP     FOLD
        ELSE
TOUCH:  LDA     PX
        CMP     L
        JNZ     TOUCHN
        ENDIF
TOUCHS: LDA     PHI             ; the same column
        CMP     B
        JNC     TOUCH1
        MOV     A,B
        STA     PHI
TOUCH1: LDA     PLO
        CMP     B
        RC
        MOV     A,B
        STA     PLO
        RET
TOUCHN: CALL    FOLD            ; another one
        MOV     A,L
        STA     PX
        MOV     A,B
        STA     PLO
        STA     PHI
        RET

; TESTDRAW: a dot of slack, no masks.
STEPT:  CALL    SEENT
        JC      PLOT
        RET

; Carry when a dot of TESTDRAW is visible: by its own column, or by a visited one beside it, which shows it on its masks
; and beyond. Keeps L, BC, DE.
SEENT:  MVI     H,MTP
        MOV     A,M
        SUB     B
        RC
        CPI     2
        RC
        INR     H
        MOV     A,B
        SUB     M
        RC
        CPI     2
        RC
        MVI     H,MTP
        MOV     A,L
        DCR     L
        CALL    SEENB
        INR     L
        RC
        MVI     H,MTP
        INR     L
        MOV     A,L
        CALL    SEENB
        DCR     L
        RET
SEENB:  CALL    FSIDE
        RZ                      ; no carry
        MOV     A,B
        CMP     M
        CMC
        RC                      ; B >= MT
        INR     H
        MOV     A,M
        CMP     B
        CMC                     ; B <= MB
        RET

; ---- Fold: the pending column's rows become part of the masks, and no column is pending. Keeps all but A.
FOLD:   PUSH    H
        LHLD    PLO
        MOV     A,H
        CMP     L
        JC      FOLDZ           ; nothing pending
        PUSH    B
        MOV     B,H             ; highest
        MOV     C,L             ; lowest
        LHLD    PX
FOLDHW: CALL    FOLDK           ; FOLDC when folds are to be seen
        LXI     H,NOPEND
        SHLD    PLO
        POP     B
FOLDZ:  POP     H
        RET

; Rows C (lowest) to B of the column in HL. Keeps L, BC, DE.
FOLDK:  MOV     A,M
        CMP     B
        JNC     FOLDK2
        ORA     A
        JNZ     FOLDK1
        INR     H
        MOV     A,M
        DCR     H
        INR     A
        JZ      FOLDNW          ; unvisited
FOLDK1: MOV     M,B
FOLDK2: INR     H
        MOV     A,C
        CMP     M
        RNC
        MOV     M,C
        RET
FOLDNW: MOV     M,B
        INR     H
        MOV     M,C
        RET
