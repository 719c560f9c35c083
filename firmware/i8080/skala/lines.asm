; Hidden lines on the EF9365 board (the paper's algorithm 3.1), as fast as they can be had: DRAW with the visibility
; test, no silhouettes. All other cases go through steps.asm and draw the same.
;
; Between two DRAW commands all state stays in registers: L = xp, B = yp, and H says what is still to be done to the
; masks in the column of the pen, where they are kept as they were before the line came into it:
;   MTP     the top becomes B       (the last point was above)
;   MBP     the bottom becomes B    (below)
;   S0P     nothing                 (hidden, or the column is folded)
;   S1P     nothing: the line came in above and ran down; MT has the new top, OLDM the old one + 1
;   S2P     nothing: the line came in below and ran up; MB has the new bottom, OLDM the old one
; so that MOV M,B folds the column in every case, the last three into a page nobody reads.
;
; Along x a column is entered once: it is tested and folded in one, but for the last. Along y a line within a column
; has parts: P1 outside where it came in, P2 hidden, P3 outside on the other side; each needs one comparison at most.

OLDM:   DB      0

; DRAW from memory's state.
DRAWV:  POP     D
        LXI     H,STEPD
        SHLD    GSTEP+1
        SHLD    FSTEP+1
        CALL    FIRST
        LHLD    PLO
        MOV     A,H
        CMP     L
        LHLD    XYP
        MOV     B,H
        MVI     H,S0P
        JC      VLINE           ; nothing pending
        LDA     PX
        CMP     L
        JNZ     GLINE           ; pending elsewhere: only after TESTDRAW
        CALL    DRAWVP
        JC      DRAWV2
        PUSH    H
        LXI     H,NOPEND
        SHLD    PLO
        POP     H
        JMP     VLINE
DRAWV2: MOV     A,E             ; a line along x leaves the column at once
        SUB     L
        JNC     DRAWV3
        CMA
        INR     A
DRAWV3: MOV     C,A
        MOV     A,D
        SUB     B
        JNC     DRAWV4
        CMA
        INR     A
DRAWV4: CMP     C
        JC      DRAWV5
        JNZ     GLINE
        ORA     A
        JZ      NEXT            ; no length
DRAWV5: CALL    FOLD
        MVI     H,S0P
        JMP     VLINE

; What the pending column is for the fast loops: H as above, or carry when they cannot have it. Keeps DE, L, B.
DRAWVP: MVI     H,MTP
        MOV     A,M
        INR     H
        CMP     M
        RC                      ; unvisited
        LDA     PLO
        CMP     M
        JC      DRAWV1          ; below
        DCR     H
        LDA     PHI
        CMP     M
        MVI     H,S0P
        RZ
        CMC
        RNC
        MVI     H,MTP           ; above: the pen must be at the highest row
        CMP     B
        RZ
        STC
        RET
DRAWV1: CMP     B
        STC
        RNZ
        DCR     H
        LDA     PHI
        CMP     M
        MVI     H,MBP
        RZ
        CMC
        RET

; The chain goes on with something else: A = command.
VSPILL: MOV     C,A
        CALL    SPILL
        MOV     H,B
        SHLD    XYP
        MOV     A,C
        JMP     DISP

; The pending column back into memory, the masks as before it. Keeps BC, DE, L.
SPILL:  MOV     A,H
        CPI     S0P
        RZ
        MOV     A,L
        STA     PX
        MOV     A,B
        STA     PLO
        STA     PHI
        MOV     A,H
        CPI     S1P
        RC
        JNZ     SPILL2
        MVI     H,MTP
        MOV     A,M
        STA     PHI
        LDA     OLDM
        DCR     A
        MOV     M,A
        RET
SPILL2: CPI     S2P
        RNZ
        MVI     H,MBP
        MOV     A,M
        STA     PLO
        LDA     OLDM
        MOV     M,A
        RET

; ---- Along x. RIGHT: 1 to the right; DX, DY: INR or DCR. In: A = u, D = v, E free.
ALONGX  MACRO   RIGHT,DX,DY
        LOCAL   LOOP,TEST,MINOR,SUB1,ABOVE,ABOVE1,EMPTY,EMPTY1,BELOW,LAST,LAST1
        STA     SUB1+1
        MOV     E,A
        IF      RIGHT
        XRA     A
        SUB     E
        JZ      VNEXT           ; no length
        ELSE
        CMA
        STC
        ENDIF
        RAR
        MOV     C,A
        MOV     M,B             ; fold the column of the pen
        MVI     H,MTP
        MOV     A,B
        OUT     GDPY
        DCR     E
        JZ      LAST
LOOP:   MOV     A,C
        ADD     D
        JC      MINOR
        MOV     C,A
        DX      L
        MOV     A,M
        CMP     B
        JC      ABOVE
        INR     H
        MOV     A,B
        CMP     M
        JC      BELOW
        DCR     H
        DCR     E
        JNZ     LOOP
        JMP     LAST
MINOR:
SUB1:   SUI     0
        MOV     C,A
        DY      B
        MOV     A,B
        OUT     GDPY
        DX      L
        MOV     A,M
        CMP     B
        JC      ABOVE
        INR     H
        MOV     A,B
        CMP     M
        JC      BELOW
        DCR     H
        DCR     E
        JNZ     LOOP
        JMP     LAST
EMPTY:  INR     H               ; MT = 0: unvisited when MB = 255
        MOV     A,M
        INR     A
        JNZ     EMPTY1
        MOV     M,B
EMPTY1: DCR     H
        JMP     ABOVE1
BELOW:  MOV     M,B
        DCR     H
        MOV     A,L
        OUT     GDPX
        MVI     A,DOT
        OUT     GDPCMD
        DCR     E
        JNZ     LOOP
        JMP     LAST
ABOVE:  ORA     A
        JZ      EMPTY
ABOVE1: MOV     M,B
        MOV     A,L
        OUT     GDPX
        MVI     A,DOT
        OUT     GDPCMD
        DCR     E
        JNZ     LOOP
LAST:   MOV     A,C             ; the last column is left pending
        ADD     D
        JNC     LAST1
        DY      B
        MOV     A,B
        OUT     GDPY
LAST1:  DX      L
        MOV     A,M
        CMP     B
        JC      VABOVE
        INR     H
        MOV     A,B
        CMP     M
        JC      VBELOW
        MVI     H,S0P
        JMP     VNEXT
        ENDM

; ---- Along y, upwards. In: A = C = u, D = v.
UPWARD  MACRO   RIGHT,DX,DXCODE
        LOCAL   BELOW,P1GO,P1LOOP,P1END,OLD,P1HID,P1OUT,P2GO,P2LOOP,P3DOT,P3LOOP,P3NEW,NEW,SUB1,COLUMN,FIRST1
        LOCAL   ABOVE,BELOW1,BELOW2,SLOW,CROSS,TURN
        MOV     A,D
        STA     SUB1+1
        MOV     E,A
        MOV     D,C
        IF      RIGHT
        XRA     A
        SUB     E
        ELSE
        CMA
        STC
        ENDIF
        RAR
        MOV     C,A
        MOV     A,L
        OUT     GDPX
        MOV     A,H
        CPI     S0P
        JZ      FIRST1
        CPI     MTP
        JZ      P3LOOP
        CPI     MBP
        JZ      BELOW
        CPI     S2P
        JZ      P1GO
TURN:   CALL    SPILL           ; came in above, ran down, and now turns: step by step
        MVI     A,INRB
        STA     GMAJ
        MVI     A,DXCODE
        STA     GMIN
        LDA     SUB1+1
        STA     GSUB+1
        CALL    GLOOP
        JMP     NEXT
BELOW:  MOV     A,M             ; the point before becomes the new bottom, the old one is kept beside
        INR     A
        JZ      TURN            ; unvisited but for row 0
        DCR     A
        STA     OLD+1
        MOV     M,B
        JMP     P1LOOP
P1GO:   MVI     H,MTP
        LDA     OLDM
        STA     OLD+1
        CMP     B
        JC      P2GO
        JZ      P2GO

P1LOOP: MOV     A,C             ; P1: below the old bottom
        ADD     D
        JC      NEW
        MOV     C,A
        INR     B
        MOV     A,B
OLD:    CPI     0
        JNC     P1HID
P1OUT:  OUT     GDPY
        MVI     A,DOT
        OUT     GDPCMD
        DCR     E
        JNZ     P1LOOP
P1END:  LDA     OLD+1
        STA     OLDM
        MVI     H,S2P
        JMP     VNEXT
P1HID:  MVI     H,MTP
        DCR     E
        JZ      P1END
P2GO:   MOV     A,C             ; P2 after P1
        ADD     D
        JC      NEW
        MOV     C,A
        INR     B
        MOV     A,M
        CMP     B
        JC      CROSS
        DCR     E
        JNZ     P2GO
        JMP     P1END
CROSS:  MOV     A,L             ; through both masks in one column: step by step
        STA     PX
        MOV     A,B
        DCR     A
        STA     PHI
        INR     H
        MOV     A,M
        STA     PLO
        LDA     OLD+1
        MOV     M,A
SLOW:   MVI     A,INRB
        STA     GMAJ
        MVI     A,DXCODE
        STA     GMIN
        LDA     SUB1+1
        STA     GSUB+1
        CALL    GSTEP
        JMP     NEXT

P3NEW:  MOV     M,B
NEW:
SUB1:   SUI     0               ; a new column
        MOV     C,A
        INR     B
        DX      L
        MOV     A,L
        OUT     GDPX
COLUMN: MVI     H,MTP
        MOV     A,M
        CMP     B
        JC      ABOVE
        INR     H
        MOV     A,B
        CMP     M
        JC      BELOW1
        DCR     H
        DCR     E
        JNZ     P2LOOP
        MVI     H,S0P
        JMP     VNEXT
P2LOOP: MOV     A,C             ; P2: hidden
        ADD     D
        JC      NEW
        MOV     C,A
        INR     B
        MOV     A,M
        CMP     B
        JC      P3DOT
        DCR     E
        JNZ     P2LOOP
        MVI     H,S0P
        JMP     VNEXT
FIRST1: MOV     A,C
        ADD     D
        JC      NEW
        MOV     C,A
        INR     B
        JMP     COLUMN
BELOW1: MOV     A,M
        INR     A
        JNZ     BELOW2
        DCR     H
        MOV     A,M
        INR     H
        ORA     A
        JZ      SLOW            ; unvisited
BELOW2: MOV     A,M
        STA     OLD+1
        MOV     M,B
        MOV     A,B
        JMP     P1OUT
ABOVE:  ORA     A
        JNZ     P3DOT
        INR     H
        MOV     A,M
        DCR     H
        INR     A
        JZ      SLOW            ; unvisited
P3DOT:  MOV     A,B
        OUT     GDPY
        MVI     A,DOT
        OUT     GDPCMD
        DCR     E
        JZ      VNEXT
P3LOOP: MOV     A,C             ; P3: above
        ADD     D
        JC      P3NEW
        MOV     C,A
        INR     B
        MOV     A,B
        OUT     GDPY
        MVI     A,DOT
        OUT     GDPCMD
        DCR     E
        JNZ     P3LOOP
        JMP     VNEXT
        ENDM

; ---- Along y, downwards: the mirror image. H = MBP where upwards it is MTP.
DNWARD  MACRO   RIGHT,DX,DXCODE
        LOCAL   ABOVE,P1GO,P1LOOP,P1END,OLD,P1HID,P1OUT,P2GO,P2LOOP,P3DOT,P3LOOP,P3NEW,NEW,SUB1,COLUMN,FIRST1
        LOCAL   BELOW,ABOVE1,ABOVE2,SLOW,CROSS
        MOV     A,D
        STA     SUB1+1
        MOV     E,A
        MOV     D,C
        IF      RIGHT
        XRA     A
        SUB     E
        ELSE
        CMA
        STC
        ENDIF
        RAR
        MOV     C,A
        MOV     A,L
        OUT     GDPX
        MOV     A,H
        CPI     S0P
        JZ      FIRST1
        CPI     MBP
        JZ      P3LOOP
        CPI     MTP
        JZ      ABOVE
        CPI     S1P
        JZ      P1GO
        CALL    SPILL           ; came in below, ran up, and now turns
        MVI     A,DCRB
        STA     GMAJ
        MVI     A,DXCODE
        STA     GMIN
        LDA     SUB1+1
        STA     GSUB+1
        CALL    GLOOP
        JMP     NEXT
ABOVE:  MOV     A,M
        INR     A
        STA     OLD+1           ; the old top + 1: visible is what is not below that
        MOV     M,B
        JMP     P1LOOP
P1GO:   MVI     H,MBP
        LDA     OLDM
        STA     OLD+1
        CMP     B
        JC      P1LOOP
        JNZ     P2GO

P1LOOP: MOV     A,C             ; P1: above the old top
        ADD     D
        JC      NEW
        MOV     C,A
        DCR     B
        MOV     A,B
OLD:    CPI     0
        JC      P1HID
P1OUT:  OUT     GDPY
        MVI     A,DOT
        OUT     GDPCMD
        DCR     E
        JNZ     P1LOOP
P1END:  LDA     OLD+1
        STA     OLDM
        MVI     H,S1P
        JMP     VNEXT
P1HID:  MVI     H,MBP
        DCR     E
        JZ      P1END
P2GO:   MOV     A,C             ; P2 after P1
        ADD     D
        JC      NEW
        MOV     C,A
        DCR     B
        MOV     A,B
        CMP     M
        JC      CROSS
        DCR     E
        JNZ     P2GO
        JMP     P1END
CROSS:  MOV     A,L             ; through both masks in one column
        STA     PX
        MOV     A,B
        INR     A
        STA     PLO
        DCR     H
        MOV     A,M
        STA     PHI
        LDA     OLD+1
        DCR     A
        MOV     M,A
SLOW:   MVI     A,DCRB
        STA     GMAJ
        MVI     A,DXCODE
        STA     GMIN
        LDA     SUB1+1
        STA     GSUB+1
        CALL    GSTEP
        JMP     NEXT

P3NEW:  MOV     M,B
NEW:
SUB1:   SUI     0               ; a new column
        MOV     C,A
        DCR     B
        DX      L
        MOV     A,L
        OUT     GDPX
COLUMN: MVI     H,MBP
        MOV     A,B
        CMP     M
        JC      BELOW
        DCR     H
        MOV     A,M
        CMP     B
        JC      ABOVE1
        INR     H
        DCR     E
        JNZ     P2LOOP
        MVI     H,S0P
        JMP     VNEXT
P2LOOP: MOV     A,C             ; P2: hidden
        ADD     D
        JC      NEW
        MOV     C,A
        DCR     B
        MOV     A,B
        CMP     M
        JC      P3DOT
        DCR     E
        JNZ     P2LOOP
        MVI     H,S0P
        JMP     VNEXT
FIRST1: MOV     A,C
        ADD     D
        JC      NEW
        MOV     C,A
        DCR     B
        JMP     COLUMN
ABOVE1: ORA     A
        JNZ     ABOVE2
        INR     H
        MOV     A,M
        DCR     H
        INR     A
        JZ      SLOW            ; unvisited
ABOVE2: MOV     A,M
        INR     A
        STA     OLD+1
        MOV     M,B
        MOV     A,B
        JMP     P1OUT
BELOW:  MOV     A,M
        INR     A
        JNZ     P3DOT
        DCR     H
        MOV     A,M
        INR     H
        ORA     A
        JZ      SLOW            ; unvisited
P3DOT:  MOV     A,B
        OUT     GDPY
        MVI     A,DOT
        OUT     GDPCMD
        DCR     E
        JZ      VNEXT
P3LOOP: MOV     A,C             ; P3: below
        ADD     D
        JC      P3NEW
        MOV     C,A
        DCR     B
        MOV     A,B
        OUT     GDPY
        MVI     A,DOT
        OUT     GDPCMD
        DCR     E
        JNZ     P3LOOP
        JMP     VNEXT
        ENDM

; ---- The end of a line along x: its last point is visible.
VABOVE: ORA     A
        JNZ     VBELOW
        INR     H
        MOV     A,M
        DCR     H
        INR     A
        JZ      VFIRST
VBELOW: MOV     A,L
        OUT     GDPX
        MVI     A,DOT
        OUT     GDPCMD

; ---- The next command of the chain.
VNEXT:  DCX     SP
        POP     PSW
        CPI     2
        JNZ     VSPILL
        POP     D
VLINE:  MOV     A,E
        SUB     L
        JC      VLEFT
        MOV     C,A             ; C = u
        MOV     A,D
        SUB     B
        JC      VRDN
        MOV     D,A             ; D = v
        MOV     A,C
        CMP     D
        JC      VRUPY
        ALONGX  1,INR,INR
VRUPY:  UPWARD  1,INR,INRL

VRDN:   CMA
        INR     A
        MOV     D,A
        MOV     A,C
        CMP     D
        JC      VRDNY
        ALONGX  1,INR,DCR
VRDNY:  DNWARD  1,INR,INRL

VLEFT:  CMA
        INR     A
        MOV     C,A
        MOV     A,D
        SUB     B
        JC      VLDN
        MOV     D,A
        MOV     A,C
        CMP     D
        JC      VLUPY
        ALONGX  0,DCR,INR
VLUPY:  UPWARD  0,DCR,DCRL

VLDN:   CMA
        INR     A
        MOV     D,A
        MOV     A,C
        CMP     D
        JC      VLDNY
        ALONGX  0,DCR,DCR
VLDNY:  DNWARD  0,DCR,DCRL

; The first point ever in a column: both masks wait for it, in memory.
VFIRST: MOV     A,L
        OUT     GDPX
        MVI     A,DOT
        OUT     GDPCMD
        MOV     H,B
        SHLD    XYP
        MOV     A,L
        STA     PX
        MOV     A,B
        STA     PLO
        STA     PHI
        JMP     NEXT
