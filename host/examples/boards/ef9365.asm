; EF9365 raster board: a frame, a diagonal dotted line, a word and a staircase of small vectors, each in a colour of its own.
; Look at WAIT: nothing is written to the chip before the last command is done.
CMD     EQU     40H             ; register 0: command, and status when read
CTRL1   EQU     41H
CTRL2   EQU     42H
CSIZE   EQU     43H
DELTAX  EQU     45H
DELTAY  EQU     47H
XLOW    EQU     49H
YLOW    EQU     4BH
LATCH   EQU     50H             ; colour of the pen: bits 2-0, one for each plane

        ORG     0100H
        LXI     SP,8000H
        MVI     A,07H           ; clear the screen, all registers to their first values
        CALL    ORDER
        MVI     A,3             ; pen down, and it writes
        OUT     CTRL1
        MVI     A,7             ; white
        OUT     LATCH
        MVI     A,20            ; the frame's corner
        OUT     XLOW
        OUT     YLOW
        MVI     A,215
        OUT     DELTAX
        OUT     DELTAY
        MVI     A,10H           ; vectors of DELTAX, DELTAY: right, up, left, down
        CALL    ORDER
        MVI     A,12H
        CALL    ORDER
        MVI     A,16H
        CALL    ORDER
        MVI     A,14H
        CALL    ORDER
        MVI     A,4             ; the diagonal, dotted
        OUT     LATCH
        MVI     A,1
        OUT     CTRL2
        MVI     A,11H           ; right and up
        CALL    ORDER
        XRA     A               ; lines are whole again
        OUT     CTRL2
        MVI     A,2
        OUT     LATCH
        MVI     A,33H           ; characters three times as wide and as high
        OUT     CSIZE
        MVI     A,40
        OUT     XLOW
        MVI     A,190
        OUT     YLOW
        LXI     H,TEXT
NEXT:   MOV     A,M
        ORA     A
        JZ      STAIRS
        CALL    ORDER           ; codes 20 to 7F draw a character
        INX     H
        JMP     NEXT
STAIRS: MVI     A,6
        OUT     LATCH
        MVI     A,120
        OUT     XLOW
        MVI     A,40
        OUT     YLOW
        MVI     B,30
STEP:   MVI     A,0E0H          ; small vector: 3 to the right
        CALL    ORDER
        MVI     A,9AH           ; 3 up
        CALL    ORDER
        DCR     B
        JNZ     STEP
        HLT

ORDER:  OUT     CMD
WAIT:   IN      CMD
        ANI     04H             ; READY
        JZ      WAIT
        RET

TEXT:   DB      'EF9365',0
        END
