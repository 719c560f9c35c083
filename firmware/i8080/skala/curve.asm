; CURVE: one row a column, joined by the line algorithm.

CURX:   DB      0
CURN:   DB      0

; By lines, on any device.
CURVEG: POP     D               ; E = x, D = n
        XCHG
        SHLD    CURX
        XCHG
        DCX     SP
        POP     PSW
        MOV     D,A
        CALL    MOVETO
        LHLD    DSTEP
        SHLD    GSTEP+1
        SHLD    FSTEP+1
        CALL    FIRST
CURVE1: LXI     H,CURN
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
        JMP     CURVE1
