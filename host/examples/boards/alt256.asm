; ALT-256 raster board: eight diagonal lines in eight colours. Look at the T-states: a dot costs a scan line, 63.5 us.
DATA    EQU     30H             ; the write draws the dot; status when read
X       EQU     31H
Y       EQU     32H
ERASE   EQU     33H

        ORG     0100H
        LXI     SP,8000H
        CALL    WAIT
        XRA     A
        OUT     ERASE           ; 33.3 ms
        MVI     C,7             ; colour
LINE:   MVI     B,0             ; place on the line
DOT:    CALL    WAIT
        MOV     A,B
        OUT     X
        MOV     A,C             ; Y = 16 * colour + place / 2
        RLC
        RLC
        RLC
        RLC
        MOV     D,A
        MOV     A,B
        ORA     A
        RAR
        ADD     D
        OUT     Y
        MOV     A,C
        OUT     DATA
        INR     B
        JNZ     DOT
        DCR     C
        JNZ     LINE
        HLT

WAIT:   IN      DATA
        RLC                     ; bit 7, ready, into the carry
        JNC     WAIT
        RET
        END
