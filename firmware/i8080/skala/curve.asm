; CURVE: one row a column, joined by the line algorithm.

CURX:   DB      0
CURN:   DB      0

; By lines, on any device.
CURVEG: CALL    CURVE0
CURVE1: LHLD    DSTEP
        SHLD    GSTEP+1
        SHLD    FSTEP+1
        CALL    FIRST
CURVE2: LXI     H,CURN
        DCR     M
        JZ      NEXT
        DCX     H
        INR     M
        MOV     E,M
        DCX     SP
        POP     PSW
        MOV     D,A
        CALL    GSET
        CALL    GLOOP           ; one column on: never without length
        JMP     CURVE2

; The pen to the first point.
CURVE0: POP     H               ; the way back
        POP     D
        XCHG
        SHLD    CURX
        XCHG
        DCX     SP
        POP     PSW
        MOV     D,A
        PUSH    H
        JMP     MOVETO

; ---- On the EF9365 board, a column at a time. A line one column on is upright when it has two rows or more, and changes
; column after half of them; so when the next row is known the column's rows are known: one interval, tested, drawn and
; folded at once. L = x, B, C = its highest and lowest row, D = the point's row, E = points left.

; Does the column in HL, but for the stores of visible columns of several rows, left to COL.
DOCOL   MACRO   VISIBL,COL
        LOCAL   ABOVE,ALL,DONE
        IF      VISIBL
        MOV     A,M
        CMP     B
        JC      ABOVE
        INR     H
        MOV     A,C
        CMP     M
        DCR     H
        JNC     DONE
        CALL    COL
        JMP     DONE
ABOVE:  ORA     A
        JZ      ALL
        MOV     A,C
        CMP     B
        JNZ     ALL
        MOV     M,B
        ELSE
        MOV     A,C
        CMP     B
        JNZ     ALL
        ENDIF
        MOV     A,L
        OUT     GDPX
        MOV     A,B
        OUT     GDPY
        MVI     A,DOT
        OUT     GDPCMD
        JMP     DONE
ALL:    CALL    COL
DONE:
        ENDM

COLS    MACRO   VISIBL,COL,NEXTY,LASTC
        LOCAL   FLAT,DOWN,UP3,DOWN3,LOW1,HIGH1
FLAT:   MOV     D,H             ; at most one row on: the column ends here
        MVI     H,MTP
        DOCOL   VISIBL,COL
        MOV     B,D
        MOV     C,D
        INR     L
NEXTY:  DCR     E
        JZ      LASTC
        DCX     SP
        POP     PSW
        MOV     H,A
        SUB     D
        JC      DOWN
        CPI     2
        JC      FLAT
        DCR     A               ; up: (v-1)/2 more rows here
        RAR
        ADD     D
        CMP     B
        JC      UP3
        MOV     B,A
UP3:    INR     A
        STA     LOW1+1
        MOV     D,H
        CALL    COL
LOW1:   MVI     C,0
        MOV     B,D
        INR     L
        JMP     NEXTY
DOWN:   CPI     0FFH
        JZ      FLAT
        CMA                     ; v-1
        ORA     A
        RAR
        CMA
        INR     A
        ADD     D
        CMP     C
        JNC     DOWN3
        MOV     C,A
DOWN3:  DCR     A
        STA     HIGH1+1
        MOV     D,H
        CALL    COL
HIGH1:  MVI     B,0
        MOV     C,D
        INR     L
        JMP     NEXTY
        ENDM

; With visibility: when the pen is fresh and the pending column another one, which nearly always is so.
CURVEV: CALL    CURVE0
        LDA     FRESH
        ORA     A
        JZ      CURVE1
        LHLD    XYP
        XCHG
        LHLD    PLO
        MOV     A,H
        CMP     L
        JC      CURVV1
        LDA     PX
        CMP     E
        JZ      CURVE1
        CALL    FOLD
CURVV1: XRA     A
        STA     FRESH
        MOV     B,D
        MOV     C,D
        LHLD    CURX            ; L = x, H = n
        MOV     E,H
        MVI     H,MTP
        JMP     CVNEXT
        COLS    1,CVCOL,CVNEXT,CVLAST

; The last column: drawn, but left pending, its masks as they were.
CVLAST: MOV     H,D
        SHLD    XYP
        MOV     A,L
        STA     PX
        MOV     H,B
        MOV     L,C
        SHLD    PLO
        LHLD    PX
        MOV     D,M
        INR     H
        MOV     E,M
        CALL    CVCOL
        LHLD    PX
        MOV     M,D
        INR     H
        MOV     M,E
        JMP     NEXT

; Column L from B down to C. Keeps L, DE, and H = MTP.
CVCOL:  MVI     H,MTP
        MOV     A,L
        OUT     GDPX
        MOV     A,M
        CMP     B
        JNC     CVCOL4
        ORA     A
        JNZ     CVCOL1
        INR     H
        MOV     A,M
        DCR     H
        INR     A
        JZ      CVCOL8          ; unvisited
CVCOL1: MOV     A,M             ; rows above the top
        MOV     M,B
        CMP     C
        JNC     CVCOL2
        MOV     A,C
        DCR     A
CVCOL2: MOV     H,A
        MOV     A,B
        SUB     H
        MOV     H,A
CVCOL3: MOV     A,B
        OUT     GDPY
        MVI     A,DOT
        OUT     GDPCMD
        DCR     B
        DCR     H
        JNZ     CVCOL3
        MVI     H,MTP
CVCOL4: INR     H
        MOV     A,C
        CMP     M
        JNC     CVCOL7
        MOV     A,M             ; rows below the bottom
        MOV     M,C
        DCR     A
        CMP     B
        JC      CVCOL5
        MOV     A,B
CVCOL5: SUB     C
        INR     A
        MOV     H,A
CVCOL6: MOV     A,C
        OUT     GDPY
        MVI     A,DOT
        OUT     GDPCMD
        INR     C
        DCR     H
        JNZ     CVCOL6
CVCOL7: MVI     H,MTP
        RET
CVCOL8: MOV     M,B
        INR     H
        MOV     M,C
        MOV     A,B
        JMP     CVCOL5

; Without.
CURVEP: CALL    CURVE0
        LDA     FRESH
        ORA     A
        JZ      CURVE1
        XRA     A
        STA     FRESH
        LHLD    XYP
        MOV     B,H
        MOV     C,H
        MOV     D,H
        LHLD    CURX
        MOV     E,H
        JMP     CPNEXT
        COLS    0,CPCOL,CPNEXT,CPLAST

CPLAST: MOV     H,D
        SHLD    XYP
        CALL    CPCOL
        JMP     NEXT

CPCOL:  MOV     A,L
        OUT     GDPX
        MOV     A,B
        JMP     CVCOL5
