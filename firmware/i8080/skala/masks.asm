; MASK: a line that only hides. What counts of a column is its lowest and its highest row.

MASKV:  POP     D
        LXI     H,TOUCH
        SHLD    GSTEP+1
        SHLD    FSTEP+1
        CALL    FIRST
        CALL    GSET
        JZ      MASKNF
        LDA     PX              ; as nearly always: the pen's column is pending, the pen in it
        CMP     L
        JNZ     MASKV1
        LDA     PLO
        CMP     B
        JZ      MASKV2
        JNC     MASKV1
MASKV2: LDA     PHI
        CMP     B
        JC      MASKV1
        LDA     GMAJ
        CPI     INRL
        JC      MASKY
        JMP     MASKX
MASKV1: CALL    GLOOP
        JMP     MASKNF

; On a plotter.
MASKG:  POP     D
        LXI     H,STEPMQ
        SHLD    GSTEP+1
        SHLD    FSTEP+1
        CALL    FIRST
        CALL    GSET
        CNZ     GLOOP
        JMP     MASKNF

; Without visibility it only moves the pen; on a plotter that is the end of a run.
MASKN:  POP     D
        LHLD    XYP
        MOV     A,L
        CMP     E
        JNZ     MASKN1
        MOV     A,H
        CMP     D
        JZ      MASKNF
MASKN1: XCHG
        SHLD    XYP
        CALL    RUNOFF
        JMP     MASKNF

; Along y: the first and the last row of each column are enough.
MASKY:  STA     MSKYB1
        STA     MSKYB2
        LDA     GMIN
        STA     MSKYL
        LDA     GSUB+1
        STA     MSKYS+1
MSKY1:  MOV     A,C
        ADD     D
        JC      MSKY2
        MOV     C,A
MSKYB1: INR     B
        DCR     E
        JNZ     MSKY1
        CALL    TOUCHS
        JMP     MASKND
MSKY2:
MSKYS:  SUI     0
        MOV     C,A
        CALL    TOUCHS
MSKYB2: INR     B
MSKYL:  INR     L
        CALL    TOUCHN
        DCR     E
        JNZ     MSKY1
MASKND: MOV     H,B
        SHLD    XYP
MASKNF: MVI     A,1             ; a line in ink that goes on from here inks this point
        STA     FRESH
        JMP     NEXT

; Along x: each column has one row and is folded as it is passed, but for the last. Keeps LT and HB as well, which cost
; little when nothing is to be folded there.
MASKX:  STA     MSKXL
        LDA     GMIN
        STA     MSKXB
        LDA     GSUB+1
        STA     MSKXS+1
        CALL    FOLD
MSKX1:  MOV     A,C
        ADD     D
        JNC     MSKX2
MSKXS:  SUI     0
MSKXB:  INR     B
MSKX2:  MOV     C,A
MSKXL:  INR     L
        DCR     E
        JZ      MSKX8
        MVI     H,MTP
        MOV     A,M
        CMP     B
        JC      MSKX5           ; above
        MVI     H,LTP
        MOV     A,M
        SUI     2
        JC      MSKX3
        CMP     B
        JNC     MSKX6           ; wholly below what raised the top
MSKX3:  MVI     H,MBP
        MOV     A,B
        CMP     M
        JC      MSKX7           ; below
MSKX4:  MVI     H,HBP
        MOV     A,M
        ADI     2
        JC      MSKX1
        DCR     A
        CMP     B
        JNC     MSKX1
        MVI     M,255           ; wholly above what lowered the bottom
        MOV     A,L
        STA     PX
        CALL    FBOT
        LDA     PX
        MOV     L,A
        JMP     MSKX1
MSKX5:  MOV     M,B
        MVI     H,LTP
        ORA     A
        JNZ     MSKX9
        MVI     H,MBP
        MOV     A,M
        INR     A
        JNZ     MSKX9
        MOV     M,B             ; unvisited
        JMP     MSKX1
MSKX9:  MVI     H,LTP
        MOV     M,B
        JMP     MSKX4
MSKX6:  MVI     M,0
        MOV     A,L
        STA     PX
        CALL    FTOP
        LDA     PX
        MOV     L,A
        JMP     MSKX3
MSKX7:  MOV     A,M
        MOV     M,B
        INR     A
        JNZ     MSKX10
        MVI     H,MTP
        MOV     A,M
        ORA     A
        JZ      MSKX1           ; unvisited, row 0: nothing was lowered
MSKX10: MVI     H,HBP
        MOV     M,B
        JMP     MSKX1
MSKX8:  CALL    TOUCH
        JMP     MASKND
