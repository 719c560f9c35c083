; The monitor: start, state, receipt of commands into the buffer, the end.
;
; While commands are drawn the stack pointer is the reading pointer of the buffer: POP takes two argument bytes in 10
; T-states, and a subroutine call writes only over bytes already taken. So nothing may be left on the stack between two
; commands, and no interrupt may come.

        ORG     0
        JMP     START
STATUS: DB      0               ; 0 running, else why it stopped
LINKSW: DB      0               ; 0 parallel link, 1 serial; set before the start

; ---- State (SPECIFICATION, section 2)
XYP:    DW      0               ; pen: low byte x, high byte y
FRESH:  DB      1               ; not 0: the point at the pen has not been stepped
PX:     DB      0               ; pending column; with the next byte the address of its top mask
        DB      MTP
PLO:    DB      255             ; its lowest and highest row; lowest above highest: no column is pending
PHI:    DB      0
COLR:   DB      7
SIL:    DB      0               ; colour of fold lines, 0 none
FOLDON: DB      0               ; not 0: LT and HB are kept, from the first SILHOUETTE on
DEV:    DB      0
VIS:    DB      1               ; 0: no visibility test

NOPEND  EQU     00FFH           ; PLO = 255, PHI = 0

; ---- Where each command is drawn: four bytes each, all in page 0.
MORE    EQU     15              ; the byte after the last command of a full buffer

CMDTAB: JMP     END
        NOP
        JMP     MOVE
        NOP
        JMP     VDRAW
        NOP
        JMP     VTEST
        NOP
        JMP     VMASK
        NOP
        JMP     COLOUR
        NOP
        JMP     VCOMM
        NOP
        JMP     RESET
        NOP
        JMP     VCURVE
        NOP
        JMP     SURF
        NOP
        JMP     DEVICE
        NOP
        JMP     RIM
        NOP
        JMP     SILHOU
        NOP
        JMP     OUTLIN
        NOP
        JMP     GAP
        NOP
        JMP     DOMORE

START:  DI
        LXI     SP,BUFFER
        XRA     A
        STA     STATUS
        STA     DEV
        INR     A
        STA     VIS
        CALL    RSTATE
        CALL    SETDEV
        IN      GDPCMD
        INR     A
        CNZ     GDPON
        CALL    LINKON
        ; fall into receipt

; ---- Receipt. HL = next free byte of the buffer.
RECV:   LXI     H,BUFFER
RCMD:   CALL    GETB
        CPI     15
        MVI     B,UNKNWN
        JNC     STOP
        MOV     M,A
        INX     H
        ADD     A
        MOV     E,A
        MVI     D,0
        XCHG
        LXI     B,RTAB
        DAD     B
        MOV     C,M
        INX     H
        MOV     B,M
        XCHG
        PUSH    B
        RET

RTAB:   DW      DRAWIT          ; END
        DW      RARG2           ; MOVE
        DW      RARG2           ; DRAW
        DW      RARG2           ; TESTDRAW
        DW      RARG2           ; MASK
        DW      RARG1           ; COLOUR
        DW      RFULL           ; COMMIT
        DW      RFULL           ; RESET
        DW      RCURVE
        DW      RSURF
        DW      RDEV
        DW      RARG3           ; RIM
        DW      RARG1           ; SILHOUETTE
        DW      RFULL           ; OUTLINE
        DW      RGAP

RARG3:  CALL    GETM
RARG2:  CALL    GETM
RARG1:  CALL    GETM
; A command is complete: go on, unless the buffer is nearly full.
RFULL:  MOV     A,L
        SUI     LOW (BUFEND-SLACK+1)
        MOV     A,H
        SBI     HIGH (BUFEND-SLACK+1)
        JC      RCMD
        MVI     M,MORE
        LDA     LINKSW
        ORA     A
        JZ      DRAWIT
        MVI     A,SERHLD
        OUT     SERCTL
        JMP     DRAWIT

RCURVE: CALL    RCOLS
        MOV     C,A
RCURV1: CALL    GETM
        DCR     C
        JNZ     RCURV1
        JMP     RFULL

RGAP:   CALL    RCOLS
        JMP     RFULL

RSURF:  CALL    GETM
        MOV     C,A
RSURF1: CALL    GETM
        CALL    GETM
        CALL    GETM
        DCR     C
        JNZ     RSURF1
        JMP     RFULL

RDEV:   CALL    GETM
        ANI     7FH
        CPI     4
        MVI     B,RANGE
        JNC     STOP
        JMP     RFULL

; Columns: x n. Returns A = n. x + n may be 256, not more; n = 0 is 256.
RCOLS:  CALL    GETM
        MOV     E,A
        CALL    GETM
        MOV     D,A
        ADD     E
        MVI     B,RANGE
        JC      RCOLS1
        INR     D
        DCR     D
        MOV     A,D
        RNZ                     ; n > 0 and the sum below 256
        ORA     E
        RZ                      ; 256 columns from 0
        JMP     STOP
RCOLS1: JNZ     STOP            ; above 256
        MOV     A,D
        RET

GETM:   CALL    GETB
        MOV     M,A
        INX     H
        RET

; Next byte from the host into A. Which link is decided once, at the start.
GETB:   JMP     GETPAR

GETPAR: IN      PARSTA
        ANI     PARIBF
        JZ      GETPAR
        IN      PARDAT
        RET

GETSER: IN      SERCTL
        ANI     SERRDY OR SERERR
        JZ      GETSER
        ANI     SERERR
        MVI     B,LINKER
        JNZ     STOP
        IN      SERDAT
        RET

; The 8251 is expected to come from its reset line, as at power on: its next control byte is the mode.
LINKON: LDA     LINKSW
        ORA     A
        LXI     H,GETSER
        JNZ     LINKO1
        LXI     H,GETPAR
        SHLD    GETB+1
        MVI     A,PARMOD
        OUT     PARCTL
        RET
LINKO1: SHLD    GETB+1
        MVI     A,SERMOD
        OUT     SERCTL
        MVI     A,SERRST
        OUT     SERCTL
        MVI     A,SERRUN
        OUT     SERCTL
        RET

; ---- Drawing of what is buffered
DRAWIT: LXI     SP,BUFFER
        JMP     NEXT

; The buffer has been drawn and the picture continues.
DOMORE: LXI     SP,BUFFER
        LDA     LINKSW
        ORA     A
        JZ      RECV
        MVI     A,SERRUN
        OUT     SERCTL
        JMP     RECV

; ---- The end. B = status.
STOP:   MOV     A,B
        STA     STATUS
        DI
        HLT
        JMP     STOP
