; Hidden lines on the EF9365 board along y (lines.asm has the rest, and what H means). Within a column a line has parts: P1
; outside the masks where it came in, P2 hidden, P3 outside on the other side; the end of each is one comparison away.

; ---- Along y, upwards. In: A = instruction of a step along x, C = error, D = u, E = v.
U:      STA     UDX
        MOV     A,E
        STA     USUB1+1
        MOV     A,L
        OUT     GDPX
        MOV     A,H
        CPI     S0P
        JZ      UFIRST1
        CPI     MTP
        JZ      UP3LOOP
        CPI     MBP
        JZ      UBELOW
        CPI     S2P
        JZ      UP1GO
UTURN:  CALL    SPILL           ; came in above, ran down, and now turns: step by step
        CALL    UENG
        JMP     GRUN
UBELOW: MOV     A,M             ; the point before becomes the new bottom, the old one is kept beside
        INR     A
        JZ      UTURN           ; unvisited but for row 0
        DCR     A
        STA     UOLD+1
        MOV     M,B
        JMP     UP1LOOP
UP1GO:  MVI     H,MTP
        LDA     OLDM
        STA     UOLD+1
        CMP     B
        JC      UP2GO
        JZ      UP2GO

UP1LOOP:MOV     A,C             ; P1: below the old bottom
        ADD     D
        JC      UNEW
        MOV     C,A
        INR     B
        MOV     A,B
UOLD:   CPI     0
        JNC     UP1HID
UP1OUT: OUT     GDPY
        MVI     A,DOT
        OUT     GDPCMD
        DCR     E
        JNZ     UP1LOOP
UP1END: LDA     UOLD+1
        STA     OLDM
        MVI     H,S2P
        JMP     VNEXT
UP1HID: MVI     H,MTP
        DCR     E
        JZ      UP1END
UP2GO:  MOV     A,C             ; P2 after P1
        ADD     D
        JC      UNEW
        MOV     C,A
        INR     B
        MOV     A,M
        CMP     B
        JC      UCROSS
        DCR     E
        JNZ     UP2GO
        JMP     UP1END
UCROSS: MOV     A,L             ; through both masks in one column: step by step
        STA     PX
        MOV     A,B
        DCR     A
        STA     PHI
        INR     H
        MOV     A,M
        STA     PLO
        LDA     UOLD+1
        MOV     M,A
USLOW:  CALL    UENG
        CALL    GSTEP
        JMP     NEXT
; The rest is the engine's.
UENG:   MVI     A,INRB
        STA     GMAJ
        LDA     UDX
        STA     GMIN
        LDA     USUB1+1
        STA     GSUB+1
        RET

UP3NEW: MOV     M,B
UNEW:
USUB1:  SUI     0               ; a new column
        MOV     C,A
        INR     B
UDX:   INR     L               ; or DCR L
        MOV     A,L
        OUT     GDPX
UCOLUMN:MVI     H,MTP
        MOV     A,M
        CMP     B
        JC      UABOVE
        INR     H
        MOV     A,B
        CMP     M
        JC      UBELOW1
        DCR     H
        DCR     E
        JNZ     UP2LOOP
        MVI     H,S0P
        JMP     VNEXT
UP2LOOP:MOV     A,C             ; P2: hidden
        ADD     D
        JC      UNEW
        MOV     C,A
        INR     B
        MOV     A,M
        CMP     B
        JC      UP3DOT
        DCR     E
        JNZ     UP2LOOP
        MVI     H,S0P
        JMP     VNEXT
UFIRST1:MOV     A,C
        ADD     D
        JC      UNEW
        MOV     C,A
        INR     B
        JMP     UCOLUMN
UBELOW1:MOV     A,M
        INR     A
        JNZ     UBELOW2
        DCR     H
        MOV     A,M
        INR     H
        ORA     A
        JZ      USLOW            ; unvisited
UBELOW2:MOV     A,M
        STA     UOLD+1
        MOV     M,B
        MOV     A,B
        JMP     UP1OUT
UABOVE: ORA     A
        JNZ     UP3DOT
        INR     H
        MOV     A,M
        DCR     H
        INR     A
        JZ      USLOW            ; unvisited
UP3DOT: MOV     A,B
        OUT     GDPY
        MVI     A,DOT
        OUT     GDPCMD
        DCR     E
        JZ      VNEXT
UP3LOOP:MOV     A,C             ; P3: above
        ADD     D
        JC      UP3NEW
        MOV     C,A
        INR     B
        MOV     A,B
        OUT     GDPY
        MVI     A,DOT
        OUT     GDPCMD
        DCR     E
        JNZ     UP3LOOP
        JMP     VNEXT

; ---- Along y, downwards: the mirror image. H = MBP where upwards it is MTP.
D0:     STA     DDX
        MOV     A,E
        STA     DSUB1+1
        MOV     A,L
        OUT     GDPX
        MOV     A,H
        CPI     S0P
        JZ      DFIRST1
        CPI     MBP
        JZ      DP3LOOP
        CPI     MTP
        JZ      DABOVE
        CPI     S1P
        JZ      DP1GO
        CALL    SPILL           ; came in below, ran up, and now turns
        CALL    DENG
        JMP     GRUN
DABOVE: MOV     A,M
        INR     A
        STA     DOLD+1           ; the old top + 1: rows not below it are visible
        MOV     M,B
        JMP     DP1LOOP
DP1GO:  MVI     H,MBP
        LDA     OLDM
        STA     DOLD+1
        CMP     B
        JC      DP1LOOP
        JNZ     DP2GO

DP1LOOP:MOV     A,C             ; P1: above the old top
        ADD     D
        JC      DNEW
        MOV     C,A
        DCR     B
        MOV     A,B
DOLD:   CPI     0
        JC      DP1HID
DP1OUT: OUT     GDPY
        MVI     A,DOT
        OUT     GDPCMD
        DCR     E
        JNZ     DP1LOOP
DP1END: LDA     DOLD+1
        STA     OLDM
        MVI     H,S1P
        JMP     VNEXT
DP1HID: MVI     H,MBP
        DCR     E
        JZ      DP1END
DP2GO:  MOV     A,C             ; P2 after P1
        ADD     D
        JC      DNEW
        MOV     C,A
        DCR     B
        MOV     A,B
        CMP     M
        JC      DCROSS
        DCR     E
        JNZ     DP2GO
        JMP     DP1END
DCROSS: MOV     A,L             ; through both masks in one column
        STA     PX
        MOV     A,B
        INR     A
        STA     PLO
        DCR     H
        MOV     A,M
        STA     PHI
        LDA     DOLD+1
        DCR     A
        MOV     M,A
DSLOW:  CALL    DENG
        CALL    GSTEP
        JMP     NEXT
; The rest is the engine's.
DENG:   MVI     A,DCRB
        STA     GMAJ
        LDA     DDX
        STA     GMIN
        LDA     DSUB1+1
        STA     GSUB+1
        RET

DP3NEW: MOV     M,B
DNEW:
DSUB1:  SUI     0               ; a new column
        MOV     C,A
        DCR     B
DDX:   INR     L               ; or DCR L
        MOV     A,L
        OUT     GDPX
DCOLUMN:MVI     H,MBP
        MOV     A,B
        CMP     M
        JC      DBELOW
        DCR     H
        MOV     A,M
        CMP     B
        JC      DABOVE1
        INR     H
        DCR     E
        JNZ     DP2LOOP
        MVI     H,S0P
        JMP     VNEXT
DP2LOOP:MOV     A,C             ; P2: hidden
        ADD     D
        JC      DNEW
        MOV     C,A
        DCR     B
        MOV     A,B
        CMP     M
        JC      DP3DOT
        DCR     E
        JNZ     DP2LOOP
        MVI     H,S0P
        JMP     VNEXT
DFIRST1:MOV     A,C
        ADD     D
        JC      DNEW
        MOV     C,A
        DCR     B
        JMP     DCOLUMN
DABOVE1:ORA     A
        JNZ     DABOVE2
        INR     H
        MOV     A,M
        DCR     H
        INR     A
        JZ      DSLOW            ; unvisited
DABOVE2:MOV     A,M
        INR     A
        STA     DOLD+1
        MOV     M,B
        MOV     A,B
        JMP     DP1OUT
DBELOW: MOV     A,M
        INR     A
        JNZ     DP3DOT
        DCR     H
        MOV     A,M
        INR     H
        ORA     A
        JZ      DSLOW            ; unvisited
DP3DOT: MOV     A,B
        OUT     GDPY
        MVI     A,DOT
        OUT     GDPCMD
        DCR     E
        JZ      VNEXT
DP3LOOP:MOV     A,C             ; P3: below
        ADD     D
        JC      DP3NEW
        MOV     C,A
        DCR     B
        MOV     A,B
        OUT     GDPY
        MVI     A,DOT
        OUT     GDPCMD
        DCR     E
        JNZ     DP3LOOP
        JMP     VNEXT
