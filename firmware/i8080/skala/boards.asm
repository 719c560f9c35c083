; The devices: a dot, a colour and a clear on each raster board, which routines serve which device, and whether it is there.

; These three jumps, and those of VECTOR, are replaced by SETDEV and SETMOD.
; PLOT: (L, B) in the present ink; on a plotter the next point of a visible run. Keeps L, BC, DE.
; INK: the following dots are of colour A. CLEARD: clear the picture (RESET).
PLOT:   JMP     PLOTG
INK:    JMP     INKG
CLEARD: JMP     CLEARG
DEVLEN  EQU     $-PLOT

DEVTAB: JMP     PLOTG
        JMP     INKG
        JMP     CLEARG
        JMP     PLOTA
        JMP     INKA
        JMP     CLEARA
        JMP     PLOTQ
        JMP     INKA
        JMP     CLEARQ
        JMP     PLOTQ
        JMP     INKA
        JMP     CLEARQ

PLOTG:  MOV     A,L
        OUT     GDPX
        MOV     A,B
        OUT     GDPY
        MVI     A,DOT
        OUT     GDPCMD
        RET

; The ALT-256 takes one dot a scan line.
PLOTA:  IN      ALTDAT
        RAL
        JNC     PLOTA
        MOV     A,L
        OUT     ALTX
        MOV     A,B
        OUT     ALTY
        LDA     INKNOW
        OUT     ALTDAT
        RET

INKNOW: DB      7
INKG:   OUT     GDPCOL
INKA:   STA     INKNOW
        RET

CLEARG: MVI     A,CLEAR
        OUT     GDPCMD
        CALL    GDPWT
        MVI     A,7
        JMP     INKG
GDPWT:  IN      GDPCMD
        ANI     GDPRDY
        JZ      GDPWT
        RET

CLEARA: IN      ALTDAT
        RAL
        JNC     CLEARA
        XRA     A
        OUT     ALTCLR
CLEAR1: IN      ALTDAT
        RAL
        JNC     CLEAR1
        MVI     A,7
        JMP     INKA

; The EF9365 as it is used: pen down and writing, the high bytes of X and Y 0.
GDPON:  CALL    GDPWT
        MVI     A,PENON
        OUT     GDPCT1
        XRA     A
        OUT     GDPXH
        OUT     GDPYH
        LDA     COLR
        JMP     INKG

; A chosen device must answer: an absent one's status port reads FFh.
ANSWER: LDA     DEV
        DCR     A
        JM      ANSWG
        JZ      ANSWA
        DCR     A
        RNZ                     ; the Minigraf says nothing
        IN      CALCMD
        INR     A
        RNZ
ANSWN:  MVI     B,ABSENT
        JMP     STOP
ANSWG:  IN      GDPCMD
        INR     A
        JZ      ANSWN
        JMP     GDPON
ANSWA:  IN      ALTDAT
        INR     A
        JZ      ANSWN
        LDA     COLR
        JMP     INKA

; The routines of device DEV.
SETDEV: LDA     DEV
        LXI     H,DEVTAB-DEVLEN
        LXI     D,DEVLEN
SETDE1: DAD     D
        DCR     A
        JP      SETDE1
        LXI     D,PLOT
        MVI     C,DEVLEN
        CALL    COPY
        LXI     H,QCALC
        LDA     DEV
        CPI     3
        JC      SETDE2
        LXI     H,QMINI
SETDE2: SHLD    QOUT+1

; Which routine draws each command: by device, visibility and silhouettes.
SETMOD: LXI     H,FOLDK
        LDA     DEV
        ANI     2
        MOV     B,A             ; not 0: a plotter
        LDA     FOLDON
        ORA     A
        JZ      SETMO1
        LXI     H,FOLDC
SETMO1: SHLD    FOLDHW+1
        LDA     VIS
        ORA     A
        JNZ     SETMO2
        LXI     H,PLAIN
        MOV     A,B
        ORA     A
        JZ      SETMO3
        LXI     H,PLAINQ
        JMP     SETMO3
SETMO2:
        LXI     H,PLOTTR
        MOV     A,B
        ORA     A
        JNZ     SETMO3
        LXI     H,BOARD
        LDA     FOLDON
        MOV     C,A
        LDA     DEV
        ORA     C
        JNZ     SETMO3
        LXI     H,BOARDF
SETMO3: CALL    SETVEC
        LDA     VIS
        MOV     C,A
        LDA     DEV
        ORA     C
        RNZ
        LXI     H,PLAINF
        ; fall through

SETVEC: LXI     D,VECTOR
        MVI     C,VECLEN
        CALL    COPY
        LXI     D,DSTEP
        MVI     C,9
; C bytes from HL to DE.
COPY:   MOV     A,M
        STAX    D
        INX     H
        INX     D
        DCR     C
        JNZ     COPY
        RET

; DRAW TESTDRAW MASK COMMIT CURVE; steps of DRAW, TESTDRAW, of shading and of its first point; QUICK
        IF      ATONCE
BOARDF:                         ; the fast loops have a column in registers
BOARD:  JMP     DRAWG
        JMP     TESTV
        JMP     MASKG
        ELSE
BOARDF: JMP     DRAWV           ; EF9365, no silhouettes
        JMP     TESTV
        JMP     MASKV
        JMP     COMMIT
        JMP     CURVEV
        DW      STEPD,STEPT,SHADE,SHADEF
        DB      1
BOARD:  JMP     DRAWG
        JMP     TESTV
        JMP     MASKV
        ENDIF
        JMP     COMMIT
        JMP     CURVEG
        DW      STEPD,STEPT,SHADE,SHADEF
        DB      0
PLOTTR: JMP     DRAWG
        JMP     TESTG
        JMP     MASKG
        JMP     COMMIT
        JMP     CURVEG
        DW      STEPDQ,STEPTQ,STEPDQ,STEPDQ
        DB      0
PLAIN:  JMP     DRAWG
        JMP     DRAWG
        JMP     MASKN
        JMP     COMMIN
        JMP     CURVEG
        DW      PLOT,PLOT,SHADEN,SHADNF
        DB      0
PLAINQ: JMP     DRAWG           ; a plotter
        JMP     DRAWG
        JMP     MASKN
        JMP     COMMIN
        JMP     CURVEG
        DW      PLOT,PLOT,PLOT,PLOT
        DB      0
PLAINF: JMP     DRAWP           ; EF9365
        JMP     DRAWP
        JMP     MASKN
        JMP     COMMIN
        JMP     CURVEP
        DW      PLOT,PLOT,SHADEN,SHADNF
        DB      0
