; A face: its stripes less its cuts, what the silhouette leaves of it, and the silhouette with it. Source: SPECIFICATION.md,
; section 4.

FACED:  DB      0               ; the face drawn
FPTR:   DW      0               ; slots of the line
SPTR:   DW      0

; Face A.
DRAW:   STA     FACED
        MVI     H,FS SHR 8
        MOV     B,A
        MOV     A,H
        STA     BASEH
        MOV     A,B
        CALL    BUILD
        LXI     H,CUTS
        LDA     NCUT
        MOV     C,A
DRAW1:  MOV     A,C
        ORA     A
        JZ      DRAW3
        LDA     FACED
        CMP     M
        INX     H
        JNZ     DRAW2
        PUSH    B
        PUSH    H
        MOV     A,M
        CALL    CUT
        POP     H
        POP     B
DRAW2:  INX     H
        DCR     C
        JMP     DRAW1
DRAW3:
        IF      COVER
        JMP     LAY
        ELSE
        IF      PLOTS
        LDA     MODE
        ANI     VECTOR
        JNZ     DRAW4
        ENDIF
        LDA     FACED
        CALL    RECOF
        INX     H
        INX     H
        CALL    GDPWT
        MOV     A,M
        OUT     GDPCOL
DRAW4:  LDA     YLO
        STA     LINE
        MVI     D,FS SHR 8
        CALL    SLOT16
        SHLD    FPTR
        IF      PLOTS
        LDA     YLO
        MVI     D,SS SHR 8
        CALL    SLOT32
        SHLD    SPTR
        ENDIF
DRAW5:  LDA     LINE
        LXI     H,YHI
        CMP     M
        IF      OVERW
        RZ
        LHLD    FPTR
        CALL    RUNS
DRAW8:  LHLD    FPTR
        LXI     D,16
        DAD     D
        SHLD    FPTR
        LXI     H,LINE
        INR     M
        JMP     DRAW5
        ELSE
        JZ      DRAW7
        LHLD    SPTR
        XCHG
        LHLD    FPTR
        CALL    MERGE
        LHLD    SPTR
        MVI     B,32
        CALL    TAKEU
        LDA     MODE
        ANI     VECTOR
        JZ      DRAW6
        CALL    KEEP
        JMP     DRAW8
DRAW6:  CALL    RUNS
DRAW8:  LHLD    FPTR
        LXI     D,16
        DAD     D
        SHLD    FPTR
        LHLD    SPTR
        LXI     D,32
        DAD     D
        SHLD    SPTR
        LXI     H,LINE
        INR     M
        JMP     DRAW5
DRAW7:  LDA     MODE
        ANI     VECTOR
        JNZ     TRACE
        RET
        ENDIF
        ENDIF

; The stripes at FS less those of face A.
CUT:    LHLD    YLO
        SHLD    YF
        MOV     B,A
        MVI     A,VS SHR 8
        STA     BASEH
        MOV     A,B
        CALL    BUILD
        CALL    COMMON
        LDA     FACED
        STA     FACE
CUT1:   CALL    PAIR
        JZ      CUT2
        PUSH    H
        IF      COVER
        CALL    LESSL
        POP     H
        MVI     B,48
        CALL    TAKEU
        ELSE
        CALL    MERGE
        POP     H
        MVI     B,16
        CALL    TAKEV
        ENDIF
        LXI     H,LINE
        INR     M
        JMP     CUT1
CUT2:   LHLD    YF
        SHLD    YLO
        RET

        IF      1-COVER
        IF      OVERW
; The substripes of the list at HL on the board.
RUNS:
RUNS1:  MOV     A,M
        CPI     255
        RZ
        MOV     B,A             ; from
        INX     H
        MOV     C,M             ; to before
        INX     H
        ELSE
; The substripes of the difference on the board.
RUNS:   LXI     H,VTOP-1
RUNS1:  MOV     A,M
        CPI     255
        RZ
        MOV     B,A             ; from
        DCX     H
        DCX     H
        MOV     C,M             ; to before
        DCX     H
        DCX     H
        ENDIF
        CALL    GDPWT
        MOV     A,B
        OUT     GDPX
        LDA     LINE
        OUT     GDPY
        MOV     A,C
        SUB     B
        DCR     A
        OUT     GDPDX
        MVI     A,EAST
        OUT     GDPCMD
        INR     C
        JNZ     RUNS1
        RET
        ENDIF

GDPWT:  IN      GDPCMD
        ANI     GDPRDY
        JZ      GDPWT
        RET

; The device must answer: an absent one's status reads FFh. The board is made ready and cleared, the plotter left as it is.
DEVON:  MVI     B,ABSENT
        IF      PLOTS
        LDA     MODE
        ANI     VECTOR
        JNZ     DEVON1
        ENDIF
        IN      GDPCMD
        INR     A
        JZ      STOP
        CALL    GDPWT
        XRA     A
        OUT     GDPCT2
        OUT     GDPXH
        OUT     GDPYH
        OUT     GDPDY
        MVI     A,PENON
        OUT     GDPCT1
        MVI     A,CLEAR
        OUT     GDPCMD
        RET
        IF      PLOTS
DEVON1: IN      CALCMD
        INR     A
        JZ      STOP
        RET
        ENDIF
