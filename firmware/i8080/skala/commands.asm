; Commands: which routine draws each, and the short ones.
;
; NEXT takes the next command byte from the buffer and jumps to its routine; a routine takes its arguments with POP and
; ends with JMP NEXT. Some entries of the table change with device, visibility and silhouettes (SETMOD).

NEXT:   DCX     SP
        POP     PSW             ; A = command; the flags take the byte before it
DISP:   ADD     A
        ADD     A
        ADI     LOW CMDTAB
        MOV     L,A
        MVI     H,HIGH CMDTAB
        PCHL

; MOVE: a new place for the pen, and a new run on a plotter; nothing when the pen is there.
MOVE:   POP     D
        LHLD    XYP
        MOV     A,L
        CMP     E
        JNZ     MOVE1
        MOV     A,H
        CMP     D
        JZ      NEXT
MOVE1:  XCHG
        SHLD    XYP
        MVI     A,1
        STA     FRESH
        STA     SHFRSH
        DCR     A
        STA     RUN
        JMP     NEXT

; Pen to E = x, D = y.
MOVETO: LHLD    XYP
        MOV     A,L
        CMP     E
        JNZ     MOVET1
        MOV     A,H
        CMP     D
        RZ
MOVET1: XCHG
        SHLD    XYP
        MVI     A,1
        STA     FRESH
        STA     SHFRSH
        JMP     RUNOFF

COLOUR: DCX     SP
        POP     PSW
        ANI     7
        STA     COLR
        CALL    INK
        JMP     NEXT

COMMIT: CALL    FOLD
COMMIN: MVI     A,1             ; without visibility: only a new chain of shades
        STA     SHFRSH
        JMP     NEXT

SILHOU: DCX     SP
        POP     PSW
        ANI     7
        STA     SIL
        JZ      SILHO1
        STA     FOLDON
SILHO1: CALL    SETMOD
        JMP     NEXT

RESET:  CALL    RSTATE
        CALL    SETMOD
        CALL    CLEARD
        JMP     NEXT

; State as after RESET, but for device and visibility: pen, colour, pending column, columns.
RSTATE: LXI     H,0
        SHLD    XYP
        LXI     H,NOPEND
        SHLD    PLO
        XRA     A
        STA     SIL
        STA     FOLDON
        STA     LEV
        INR     A
        STA     FRESH
        STA     SHFRSH
        MVI     A,7
        STA     COLR
        LXI     H,MT
        XRA     A
        CALL    FILLPG
        DCR     A
        CALL    FILLPG
        INR     H               ; MP means nothing where IP is 0
        INR     A
        CALL    FILLPG
        CALL    FILLPG          ; LT
        DCR     A               ; HB
FILLPG: MOV     M,A             ; A into the page H; H goes to the next
        INR     L
        JNZ     FILLPG
        INR     H
        RET

END:    CALL    PENUP
        MVI     B,COMPLT
        JMP     STOP

; DEVICE: choose it, see that it answers.
DEVICE: DCX     SP
        POP     PSW
        MOV     C,A
        ANI     7FH
        STA     DEV
        MOV     A,C
        CMA
        ANI     80H
        STA     VIS
        CALL    SETDEV
        CALL    ANSWER
        JMP     NEXT

VECTOR:
        IF      ATONCE
VDRAW:  JMP     DRAWG
        ELSE
VDRAW:  JMP     DRAWV
        ENDIF
VTEST:  JMP     TESTG
VMASK:  JMP     MASKG
VCOMM:  JMP     COMMIT
VCURVE: JMP     CURVEG
VECLEN  EQU     $-VECTOR
