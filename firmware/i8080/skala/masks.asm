; MASK: a line that only hides. What counts of a column is its lowest and its highest row, so a line along y needs no more
; of a column than where it comes in and goes out.

; ---- Along y. The steps between two columns are only counted; DX
; steps along x, D times. In: C = error, D = u, E = v.
MASKY   MACRO   DY,UP,DX
        LOCAL   FIRST0,FIRST1,NEW,STEP0,STEP1,SUB0,SUB1,ENTER,ERR,LAST,ALONE
        MOV     A,E
        STA     SUB0+1
        STA     SUB1+1
        MOV     A,B
        IF      UP
        ADD     E
        ELSE
        SUB     E
        ENDIF
        STA     LAST+1
        MOV     E,D
        INR     E
        LDA     MPEND
        ORA     A
        MOV     A,C
        JZ      NEW
        DCR     E
        JZ      ALONE
        JMP     FIRST1
FIRST0: DY      B
FIRST1: ADD     D
        JNC     FIRST0
SUB0:   SUI     0
        STA     ERR+1
        CALL    TOUCHS
        CALL    FOLD
        JMP     ENTER
NEW:    MOV     C,B
        DCR     E
        JZ      LAST
        JMP     STEP1
STEP0:  DY      B
STEP1:  ADD     D
        JNC     STEP0
SUB1:   SUI     0
        STA     ERR+1
        IF      UP
        CALL    FOLDC
        ELSE
        MOV     A,B
        MOV     B,C
        MOV     C,A
        CALL    FOLDC
        MOV     B,C
        ENDIF
ENTER:
DX:     INR     L               ; or DCR L
        DY      B
        MOV     C,B
        DCR     E
        JZ      LAST
ERR:    MVI     A,0
        JMP     STEP1
LAST:   MVI     B,0             ; in its last column a line ends without a step
        MOV     H,B
        SHLD    XYP
        IF      UP-1
        MOV     A,B
        MOV     B,C
        MOV     C,A
        ENDIF
        JMP     MSKEND
ALONE:  LDA     LAST+1          ; within the pending column
        MOV     B,A
        JMP     MSKEN2
        ENDM

MASKV:  POP     D
        LHLD    XYP
        LDA     FRESH
        ORA     A
        JZ      MASKE           ; after a line in ink: step by step
        MOV     B,H
        LDA     PLO
        MOV     H,A
        LDA     PHI
        CMP     H
        JC      MASKV1          ; nothing pending: the pen's column begins here, in registers
        LDA     PX
        CMP     L
        JZ      MASKV2
        CALL    FOLD
MASKV1: XRA     A
        JMP     MASKV3
MASKV2: CALL    TOUCHS
        MVI     A,1
MASKV3: STA     MPEND
        CALL    GDIR
        JZ      MASKV5
        JC      MASKV4

; Along x each column has one row and is folded as it is passed, but for the last. Keeps LT and HB as well, which cost
; little if there is nothing to fold.
        STA     MSKXL
        MOV     A,H
        STA     MSKXB
        MOV     A,E
        STA     MSKXS+1
        LDA     MPEND
        ORA     A
        JZ      MSKX3           ; the pen's column as well
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
MSKX3:  MVI     H,MTP
        MOV     A,M
        CMP     B
        JC      MSKX5           ; above
        MVI     H,LTP
        MOV     A,B
        CMP     M
        JC      MSKX6           ; wholly below what raised the top
        MVI     H,MBP
        CMP     M
        JC      MSKX6           ; below
MSKX4:  MVI     H,HBP
        MOV     A,M
        CMP     B
        JNC     MSKX1
MSKX6:  PUSH    B
        MOV     C,B
        CALL    FOLDC
        POP     B
        JMP     MSKX1
MSKX5:  ORA     A
        JZ      MSKX6
        MOV     M,B
        MVI     H,LTP
        MOV     A,B
        SUI     1
        ACI     0
        MOV     M,A
        JMP     MSKX4
MSKX8:  MOV     C,B
        MOV     H,B
        SHLD    XYP

; The end: rows C to B of column L are pending, or folded at once when a COMMIT follows. The pen is still fresh: a line in
; ink that goes on from here inks this point.
MSKEND: DCX     SP
        POP     PSW
        CPI     6
        JZ      MSKEN1
        MOV     E,A
        MOV     A,L
        STA     PX
        MOV     H,B
        MOV     L,C
        SHLD    PLO
        MOV     A,E
        JMP     DISP
MSKEN1: CALL    FOLDC
        JMP     COMMIN
MSKEN2: CALL    TOUCHS
        MOV     H,B
        SHLD    XYP
        JMP     NEXT

MASKV4: STA     MSKUX
        STA     MSKDX
        MOV     A,H
        CPI     INRB
        JNZ     MSKDN
        MASKY   INR,1,MSKUX
MSKDN:  MASKY   DCR,0,MSKDX

; No length: the pen's point alone.
MASKV5: LDA     MPEND
        ORA     A
        JNZ     NEXT
        MOV     C,B
        JMP     MSKEND
MPEND:  DB      0               ; not 0: the pen's column is pending

; After a line in ink the pen's point is no part of this one, unless it is pending already.
MASKE:  LXI     H,TOUCH
        SHLD    GSTEP+1
        JMP     MASKE1

; On a plotter.
MASKG:  POP     D
        LXI     H,STEPMQ
        SHLD    GSTEP+1
        SHLD    FSTEP+1
        CALL    FIRST
MASKE1: CALL    GSET
        CNZ     GLOOP
MASKNF: MVI     A,1
        STA     FRESH
        JMP     NEXT

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
