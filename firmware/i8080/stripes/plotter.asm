; The pen. Source: SPECIFICATION.md, section 4.

PENXY:  DW      0               ; where it is, x first
PENDWN: DB      0

; Pen down at (TX, TY), from wherever it is.
TRAVEL: LHLD    TX
        XCHG                    ; E = x, D = y
        LHLD    PENXY
        MOV     A,H
        CMP     D
        JNZ     TRAVE1
        MOV     A,L
        CMP     E
        JNZ     TRAVE1
        LDA     PENDWN
        ORA     A
        RNZ
        JMP     TRAVE9
TRAVE1: CALL    PENUP
TRAVE2: LHLD    TX
        XCHG
        LHLD    PENXY
        MVI     B,4             ; 3 * (dx + 1) + dy + 1
        MOV     A,L
        CMP     E
        JZ      TRAVE4
        MVI     B,7
        JC      TRAVE4
        MVI     B,1
TRAVE4: MOV     A,H
        CMP     D
        JZ      TRAVE6
        JC      TRAVE5
        DCR     B
        DCR     B
TRAVE5: INR     B
TRAVE6: MOV     A,B
        CPI     4
        JZ      TRAVE9
        MVI     D,0
        MOV     E,B
        LXI     H,DIRECT
        DAD     D
        MOV     A,M
        CALL    STEP
        JMP     TRAVE2
TRAVE9: MVI     A,1
        STA     PENDWN
        MVI     A,CALDN
        JMP     QOUT

PENUP:  LDA     PENDWN
        ORA     A
        RZ
        XRA     A
        STA     PENDWN
        MVI     A,CALUP
        JMP     QOUT

; The CalComp's code of each direction, from (-1, -1) to (1, 1); and the move of each code, dx then dy.
DIRECT: DB      5,6,7,4,0FFH,0,3,2,1
MOVES:  DB      0,1,1,1,1,0,1,-1 AND 0FFH,0,-1 AND 0FFH
        DB      -1 AND 0FFH,-1 AND 0FFH,-1 AND 0FFH,0,-1 AND 0FFH,1

; One step, code A.
STEP:   PUSH    PSW
        ADD     A
        MOV     E,A
        MVI     D,0
        LXI     H,MOVES
        DAD     D
        XCHG
        LXI     H,PENXY
        LDAX    D
        ADD     M
        MOV     M,A
        INX     D
        INX     H
        LDAX    D
        ADD     M
        MOV     M,A
        POP     PSW

; Command A to the plotter, when it is not busy. Keeps BC.
QOUT:   MOV     E,A
QOUT1:  IN      CALCMD
        RRC
        JC      QOUT1
        ANI     CALERR SHR 1
        JNZ     QOUT2
        MOV     A,E
        OUT     CALCMD
        RET
QOUT2:  MVI     B,DEVERR
        JMP     STOP
