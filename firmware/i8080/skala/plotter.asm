; Plotters: runs of visible points become pen strokes, with few lifts and no stroke of one point.

RUN:    DB      0               ; 0 no run, 1 its first point is remembered, 2 it is being drawn
RUNXY:  DW      0               ; the remembered point
PENXY:  DW      0               ; where the pen really is, low byte x
PENDWN: DB      0

; The run ends. Keeps all but A.
RUNOFF: XRA     A
        STA     RUN
        RET

; DRAW on a plotter: a point on the masks continues a run, so that lines near each other do not become dots.
STEPDQ: MVI     H,MTP
        MOV     A,M
        CMP     B
        JC      STDQ3
        JNZ     STDQ1
        LDA     RUN
        ORA     A
        JNZ     STDQ3
STDQ1:  INR     H
        MOV     A,B
        CMP     M
        JC      STDQ3
        JNZ     STDQ2
        LDA     RUN
        ORA     A
        JNZ     STDQ3
STDQ2:  CALL    RUNOFF
        JMP     TOUCH
STDQ3:  CALL    PLOT
        JMP     TOUCH

STEPTQ: CALL    SEENT
        JC      PLOT
        JMP     RUNOFF

STEPMQ: CALL    RUNOFF
        JMP     TOUCH

; The next visible point (L, B).
PLOTQ:  PUSH    B
        PUSH    D
        PUSH    H
        MOV     H,B
        LDA     RUN
        DCR     A
        JM      PLOTQ1
        JNZ     PLOTQ2
        MVI     A,2
        STA     RUN
        PUSH    H
        LHLD    RUNXY
        CALL    PENTO
        POP     H
PLOTQ2: CALL    GOTO
        JMP     PLOTQ3
PLOTQ1: SHLD    RUNXY
        MVI     A,1
        STA     RUN
PLOTQ3: POP     H
        POP     D
        POP     B
        RET

; Pen down at HL, from wherever it is.
PENTO:  LDA     PENDWN
        ORA     A
        JZ      PENTO1
        XCHG
        LHLD    PENXY
        XCHG
        MOV     A,L
        CMP     E
        JNZ     PENTO2
        MOV     A,H
        CMP     D
        RZ                      ; a run begins where the last one ended
PENTO2: PUSH    H
        CALL    PENUP
        POP     H
PENTO1: CALL    GOTO
        MVI     A,1
        STA     PENDWN
        MVI     B,CALDN
        JMP     QOUT

PENUP:  LDA     PENDWN
        ORA     A
        RZ
        XRA     A
        STA     PENDWN
        MVI     B,CALUP
        JMP     QOUT

CLEARQ: CALL    RUNOFF
        JMP     PENUP

; Step by step to HL, both axes at once while both differ.
GOTO:   XCHG                    ; DE = where to
GOTO1:  LHLD    PENXY
        MVI     B,4             ; 3 * (dx + 1) + dy + 1
        MOV     A,E
        CMP     L
        JZ      GOTO3
        JC      GOTO2
        INR     L
        INR     B
        INR     B
        INR     B
        JMP     GOTO3
GOTO2:  DCR     L
        DCR     B
        DCR     B
        DCR     B
GOTO3:  MOV     A,D
        CMP     H
        JZ      GOTO5
        JC      GOTO4
        INR     H
        INR     B
        JMP     GOTO5
GOTO4:  DCR     H
        DCR     B
GOTO5:  MOV     A,B
        CPI     4
        RZ
        SHLD    PENXY
        LXI     H,DIRECT
        ADD     L
        MOV     L,A
        MOV     A,H
        ACI     0
        MOV     H,A
        MOV     B,M
        CALL    QOUT
        JMP     GOTO1

; The CalComp's code of each direction, from (-1, -1) to (1, 1).
DIRECT: DB      5,6,7,4,0FFH,0,3,2,1

; Command B (the CalComp's code) to the plotter. Changes A, HL.
QOUT:   JMP     QCALC

QCALC:  IN      CALCMD
        RRC
        JC      QCALC
        ANI     CALERR SHR 1
        MOV     A,B
        MVI     B,DEVERR
        JNZ     STOP
        OUT     CALCMD
        RET

; The Minigraf's phases are the pen's position modulo 8. It does not say when it is done.
QMINI:  LHLD    PENXY
        MOV     A,H
        ADD     A
        ADD     A
        ADD     A
        XRA     L
        ANI     38H
        XRA     L
        ANI     3FH
        MOV     L,A
        LDA     PENDWN
        RRC
        ORA     L
        OUT     MINI
        LXI     H,417           ; 417 * 24 T-states after a step
        MOV     A,B
        CPI     CALUP
        JC      QMINI1
        LXI     H,12500         ; after a pen change
QMINI1: DCX     H
        MOV     A,H
        ORA     L
        JNZ     QMINI1
        RET
