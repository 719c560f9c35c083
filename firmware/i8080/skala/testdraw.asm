; TESTDRAW on the EF9365 board: a line tested with a dot of slack, which leaves the masks alone. Contours are many and
; short, so one loop serves all directions; its instructions of a step are put in.
;
; B = y + 1: visible from B >= MT on, or B - 3 < MB; by a column beside from B - 1 >= MT on, or B - 2 < MB. Within rows 2 to 254
; nothing of that leaves a byte; lines that touch the others go step by step. Whether there is such a column, and anyone has
; been in it, is asked last: it hardly ever fails.

TESTV:  POP     D
        LDA     DEV
        ORA     A
        JNZ     TESTX
        LHLD    XYP
        MOV     B,H
        MOV     A,H
        SUI     2
        CPI     253
        JNC     TESTX
        MOV     A,D
        SUI     2
        CPI     253
        JNC     TESTX
        CALL    GDIR
        JZ      TESTV5
        JC      TESTV1
        STA     TVMAJ
        MOV     A,H
        STA     TVMIN
        JMP     TESTV2
TESTV1: STA     TVMIN           ; along y
        MOV     A,H
        STA     TVMAJ
TESTV2: MOV     A,E
        STA     TVSUB+1
        INR     B
        LDA     FRESH
        ORA     A
        JZ      TVLOOP
        XRA     A
        STA     FRESH
        INR     E               ; the first point as well
        JMP     TVTEST
TVLOOP: MOV     A,C
        ADD     D
        JNC     TV1
TVSUB:  SUI     0
TVMIN:  INR     B
TV1:    MOV     C,A
TVMAJ:  INR     L
TVTEST: MVI     H,MTP
        MOV     A,B
        CMP     M
        JNC     TVDOT
        INR     H
        SUI     3
        CMP     M
        JC      TVDOT
        INR     A               ; hidden in its own column
        DCR     L
        CMP     M
        JC      TVLEFT
        DCR     H
        INR     A
        CMP     M
        JNC     TVLEFT
TV2:    INR     L
        INR     L
        CMP     M
        JNC     TVRGHT
        INR     H
        DCR     A
        CMP     M
        JC      TVRGHT
TV3:    DCR     L
        DCR     E
        JNZ     TVLOOP
TVEND:  DCR     B
        MOV     H,B
        SHLD    XYP
        JMP     NEXT
TVDOT:  MOV     A,L
        OUT     GDPX
        MOV     A,B
        DCR     A
        OUT     GDPY
        MVI     A,DOT
        OUT     GDPCMD
        DCR     E
        JNZ     TVLOOP
        JMP     TVEND
TVLEFT: MVI     H,MTP
        MOV     A,L
        INR     A
        CALL    FSIDE
        JZ      TVLEF1
        INR     L
        JMP     TVDOT
TVLEF1: MOV     A,B
        DCR     A
        JMP     TV2
TVRGHT: MVI     H,MTP
        MOV     A,L
        CALL    FSIDE
        JZ      TV3
        DCR     L
        JMP     TVDOT

; A piece within one dot.
TESTV5: LDA     FRESH
        ORA     A
        JZ      NEXT
        XRA     A
        STA     FRESH
        CALL    STEPT
        JMP     NEXT
