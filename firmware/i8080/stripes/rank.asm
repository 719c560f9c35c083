; The priority list. Source: SPECIFICATION.md, sections 5 and 6.

SI:     DW      0               ; places in SORT
SJ:     DW      0
SORTE:  DB      0               ; low byte after the last
FRONT:  DB      0               ; low byte of the next place in ORDER from the front
BACK:   DB      0               ; from the back
LEFT:   DB      0               ; faces left
START6: DB      0               ; where the walk around a cycle began
FOUND:  DB      0
NCUT:   DB      0

RANK:   LXI     H,SS            ; no relation, nothing hides or is hidden
        LXI     B,1000H
RANK1:  MVI     M,0
        INX     H
        DCX     B
        MOV     A,B
        ORA     C
        JNZ     RANK1
        LXI     H,NMIN
        MVI     C,192           ; NMIN, NMAX, GONE
RANK2:  MVI     M,0
        INX     H
        DCR     C
        JNZ     RANK2
        ; Faces by least X
        XRA     A
        STA     FACE
        LXI     H,SORT
RANK3:  SHLD    SJ              ; after the sorted ones
        MOV     A,L
        STA     SORTE
        LDA     COUNT
        MOV     B,A
        LDA     FACE
        CMP     B
        JZ      RANK6
        STA     FJ
RANK4:  MOV     A,L             ; the place of FACE: HL, if the one before it is not greater
        CPI     LOW SORT
        JZ      RANK5
        DCX     H
        MOV     A,M
        STA     FI
        PUSH    H
        CALL    TEST1           ; the entries of both
        LXI     B,0
        CALL    IJ
        XCHG                    ; DE that of FACE
        CALL    LESS
        POP     H
        INX     H
        JNC     RANK5
        DCX     H
        MOV     A,M
        INX     H
        MOV     M,A
        DCX     H
        JMP     RANK4
RANK5:  LDA     FJ
        MOV     M,A
        LHLD    SJ
        INX     H
        PUSH    H
        LXI     H,FACE
        INR     M
        POP     H
        JMP     RANK3

        ; All pairs
RANK6:  LXI     H,SORT
RANK7:  LDA     SORTE
        CMP     L
        JZ      CLASS
        MOV     A,M
        STA     FI
        INX     H
        SHLD    SI
RANK8:  SHLD    SJ
        LDA     SORTE
        CMP     L
        JZ      RANK9
        MOV     A,M
        STA     FJ
        CALL    TEST1
        JNC     RANK9
        CALL    TESTS
        LHLD    SJ
        INX     H
        JMP     RANK8
RANK9:  LHLD    SI
        JMP     RANK7

        ; Classes from the front and from the back
CLASS:  LDA     COUNT
        STA     LEFT
        ADI     LOW ORDER
        STA     BACK
        MVI     A,LOW ORDER
        STA     FRONT
CLASS1: LDA     LEFT
        ORA     A
        RZ
        MVI     B,0             ; face
        MVI     D,0             ; not 0: one leaves
CLASS2: CALL    GONEOF
        ORA     A
        JNZ     CLASS4
        CALL    NMINOF
        MVI     C,2
        JZ      CLASS3
        CALL    NMAXOF
        JNZ     CLASS4
        LDA     FRONT
        MOV     L,A
        MVI     H,HIGH ORDER
        MOV     M,B
        INR     A
        STA     FRONT
        MVI     C,1
CLASS3: CALL    GONEOF
        MOV     M,C
        INR     D
CLASS4: INR     B
        LDA     COUNT
        CMP     B
        JNZ     CLASS2
        MOV     A,D
        ORA     A
        JZ      CYCLE
CLASS5: DCR     B               ; those of the back from the last one down
        CALL    GONEOF
        DCR     A
        JZ      CLASS7
        DCR     A
        JNZ     CLASS8
        LDA     BACK
        DCR     A
        STA     BACK
        MOV     L,A
        MVI     H,HIGH ORDER
        MOV     M,B
CLASS7: CALL    GONEOF
        MVI     M,3
        LXI     H,LEFT
        DCR     M
        CALL    LEAVE
CLASS8: MOV     A,B
        ORA     A
        JNZ     CLASS5
        JMP     CLASS1

; Face B is no longer counted by the others.
LEAVE:  LDA     COUNT
        MOV     C,A
LEAVE1: DCR     C
        CALL    RELOF           ; B hides C
        MOV     A,M
        ORA     A
        JZ      LEAVE2
        MVI     A,LOW NMAX
        ADD     C
        MOV     L,A
        MVI     H,HIGH NMAX
        DCR     M
LEAVE2: MOV     A,B
        MOV     B,C
        MOV     C,A
        CALL    RELOF           ; C hides B
        MOV     A,B
        MOV     B,C
        MOV     C,A
        MOV     A,M
        ORA     A
        JZ      LEAVE3
        MVI     A,LOW NMIN
        ADD     C
        MOV     L,A
        MVI     H,HIGH NMIN
        DCR     M
LEAVE3: MOV     A,C
        ORA     A
        JNZ     LEAVE1
        RET

; Entry of face B in a table: HL, its value in A and the zero flag.
GONEOF: MVI     A,LOW GONE
        JMP     ENTRY
NMINOF: MVI     A,LOW NMIN
        ADD     B
        MOV     L,A
        MVI     H,HIGH NMIN
        JMP     ENTRY1
NMAXOF: MVI     A,LOW NMAX
ENTRY:  ADD     B
        MOV     L,A
        MVI     H,HIGH GONE     ; also that of NMAX
ENTRY1: MOV     A,M
        ORA     A
        RET

        ; A cycle: it is found by going from each face to one that hides it.
CYCLE:  MVI     B,255
CYCLE1: INR     B
        CALL    GONEOF
        JNZ     CYCLE1
        MVI     E,64
CYCLE2: MOV     C,B
        CALL    OCCLUD
        DCR     E
        JNZ     CYCLE2
        MOV     A,B
        STA     START6
        XRA     A
        STA     FOUND
CYCLE3: MOV     C,B             ; around it: relations of which no overlap is known
        CALL    OCCLUD
        CALL    RELOF
        MOV     A,M
        CPI     3
        JZ      CYCLE5
        MOV     A,B
        STA     FI
        MOV     A,C
        STA     FJ
        PUSH    B
        CALL    TEST6
        POP     B
        CALL    RELOF
        MVI     M,3
        LDA     WIDE
        ORA     A
        JNZ     CYCLE5
        CALL    DELETE
        MVI     A,1
        STA     FOUND
CYCLE5: LDA     START6
        CMP     B
        JNZ     CYCLE3
        LDA     FOUND
        ORA     A
        JNZ     CLASS1
        MOV     C,B             ; all are true: a cut
        CALL    OCCLUD
        MOV     A,C
        STA     FACE
        LXI     H,NCUT
        MOV     A,M
        CPI     MOSTC
        JNC     OVERF
        INR     M
        ADD     A
        ADI     LOW CUTS
        MOV     L,A
        MVI     H,HIGH CUTS
        MOV     M,C
        INX     H
        MOV     M,B
        CALL    DELETE
        JMP     CLASS1

; B = the least face left that hides C. There is one.
OCCLUD:  MVI     B,255
OCCLU1: INR     B
        CALL    GONEOF
        JNZ     OCCLU1
        CALL    RELOF
        MOV     A,M
        ORA     A
        JZ      OCCLU1
        RET

; B hides C no longer.
DELETE: CALL    RELOF
        MVI     M,0
        CALL    NMINOF
        DCR     M
        MVI     A,LOW NMAX
        ADD     C
        MOV     L,A
        MVI     H,HIGH NMAX
        DCR     M
        RET
