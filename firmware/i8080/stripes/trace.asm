; Vector output: the boundary of the visible part of a face, followed link by link. Source: SPECIFICATION.md, section 4.

TX:     DB      0               ; the point at hand
TY:     DB      0
TDIR:   DB      0               ; 0 up, 1 right, 2 down, 3 left
BX:     DB      0               ; where the walk began
BY:     DB      0
CHAIN:  DB      0               ; not 0: a chain is under way
PEND:   DB      255             ; pending link, 255 none

; What is seen in this line into its slot, as pairs of toggle and mark.
KEEP:   LDA     LINE
        MVI     D,VS SHR 8
        CALL    SLOT32
        LXI     D,VTOP-1
        MVI     C,16
KEEP1:  LDAX    D
        DCX     D
        DCX     D
        MOV     M,A
        INX     H
        MVI     M,0
        INX     H
        INR     A
        RZ
        DCR     C
        JNZ     KEEP1
        JMP     OVERF

; All loops of the face.
TRACE:  LDA     YLO
        STA     LINE
TRACE1: LDA     LINE
        LXI     H,YHI
        CMP     M
        RZ
        MVI     D,VS SHR 8
        CALL    SLOT32
TRACE2: MOV     A,M
        INR     A
        JZ      TRACE4
        MOV     B,M
        INX     H
        MOV     A,M
        ORA     A
        JNZ     TRACE3
        PUSH    H
        CALL    WALK
        POP     H
TRACE3: INX     H
        MOV     A,M             ; its east end
        INX     H
        INX     H
        INR     A
        JNZ     TRACE2
TRACE4: LXI     H,LINE
        INR     M
        JMP     TRACE1

; The loop from (B, LINE) upwards.
WALK:   MOV     A,B
        STA     TX
        STA     BX
        LDA     LINE
        STA     TY
        STA     BY
        XRA     A
        STA     TDIR
WALK1:  LDA     TDIR
        ORA     A
        CZ      MARK
        LDA     TDIR
        CALL    LEFTSQ
        CALL    COVERD          ; carry: covered, or outside the picture
        CC      ENDCH
        CNC     LINK
        LDA     TDIR            ; one link on
        LXI     H,TY
        ORA     A
        JZ      WALK2
        CPI     2
        JZ      WALK3
        DCX     H
        JNC     WALK3
WALK2:  INR     M
        JMP     WALK4
WALK3:  DCR     M
WALK4:  LDA     TDIR
        CALL    SQUARE          ; to the right ahead
        CALL    SEEN
        LDA     TDIR
        JC      WALK5
        INR     A
        JMP     WALK6
WALK5:  CALL    LEFTSQ
        CALL    SEEN
        LDA     TDIR
        JNC     WALK6
        DCR     A
WALK6:  ANI     3
        STA     TDIR
        JNZ     WALK1
        LHLD    TX              ; upwards again: at the beginning?
        XCHG
        LHLD    BX
        MOV     A,L
        CMP     E
        JNZ     WALK1
        MOV     A,H
        CMP     D
        JNZ     WALK1
        JMP     ENDCH

; The toggle at TX in line TY is walked.
MARK:   LDA     TY
        MVI     D,VS SHR 8
        CALL    SLOT32
        LDA     TX
MARK1:  CMP     M
        INX     H
        JZ      MARK2
        INX     H
        JMP     MARK1
MARK2:  MVI     M,1
        RET

; The square (B, C) to the left (SQUARE: right) of what goes from the point in direction A.
LEFTSQ: DCR     A
SQUARE: LXI     H,TX
        MOV     B,M
        INX     H
        MOV     C,M
        ANI     3
        RZ
        CPI     3
        JZ      SQUAR1
        DCR     C
        CPI     1
        RZ
SQUAR1: DCR     B
        RET

; Carry: the square (B, C) is in the visible part of the face.
SEEN:   MOV     A,B
        CPI     255
        RNC
        LXI     H,YLO
        MOV     A,C
        CMP     M
        JC      SEEN2
        INX     H
        CMP     M
        RNC
        MVI     D,VS SHR 8
        CALL    SLOT32
        MOV     A,B
SEEN1:  CMP     M
        JC      SEEN2
        INX     H
        INX     H
        CMP     M
        RC
        INX     H
        INX     H
        JMP     SEEN1
SEEN2:  ORA     A
        RET

; Carry: the square (B, C) is in the silhouette or outside the picture.
COVERD: MOV     A,B
        CPI     255
        CMC
        RC
        MOV     A,C
        CPI     255
        CMC
        RC
        MVI     D,SS SHR 8
        CALL    SLOT32
        MOV     A,B
COVER1: CMP     M
        JC      SEEN2
        INX     H
        CMP     M
        RC
        INX     H
        JMP     COVER1

; The link from (TX, TY) in direction TDIR is drawn. Leaves no carry.
LINK:   LDA     CHAIN
        ORA     A
        JNZ     LINK1
        INR     A
        STA     CHAIN
        CALL    TRAVEL
LINK1:  LDA     PEND
        MOV     B,A
        LDA     TDIR
        MOV     C,A
        INR     B
        JZ      LINK3           ; none pending
        DCR     B
        XRA     B
        RRC
        MOV     A,B
        JC      LINK2
        ADD     A               ; the pending one by itself
        CALL    STEP
        JMP     LINK3
LINK2:  MVI     A,255           ; both at once
        STA     PEND
        MOV     A,B
        ORA     A
        JZ      LINK4
        MOV     A,C
        ORA     A
        JZ      LINK5
        ADD     B
        JMP     STEP
LINK4:  MOV     A,C             ; up and right or left: 1, 7
        JMP     LINK6
LINK5:  MOV     A,B
LINK6:  CPI     1
        JZ      STEP
        MVI     A,7
        JMP     STEP
LINK3:  LDA     TDIR
        STA     PEND
        RET

; The chain ends. Leaves carry.
ENDCH:  LDA     PEND
        CPI     255
        JZ      ENDCH1
        ADD     A
        CALL    STEP
        MVI     A,255
        STA     PEND
ENDCH1: XRA     A
        STA     CHAIN
        STC
        RET
