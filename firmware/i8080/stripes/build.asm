; Stripes of a face: polygons are cut into scan lines, lists that the host made are copied. Source: SPECIFICATION.md, section 2.

BASEH:  DB      0               ; page of the slots: FS or VS
YLO:    DB      0               ; the face's lines, from
YHI:    DB      0               ; to before
RINGS:  DB      0
VERTS:  DB      0
FIRSTV: DW      0
SLOT:   DW      0
LY0:    DB      0               ; line of an edge's lower end
DY:     DB      0               ; lines of an edge
SIGN:   DB      0               ; not 0: it leans to the west
HALF:   DW      0

; HL = entry of face A. Changes DE.
EXTOF:  MOV     L,A
        MVI     H,0
        DAD     H
        DAD     H
        DAD     H
        DAD     H
        LXI     D,EXT
        DAD     D
        RET

; HL = record of face A. Changes DE.
RECOF:  ADD     A
        MOV     L,A
        MVI     H,0
        LXI     D,FACEP
        DAD     D
        MOV     E,M
        INX     H
        MOV     D,M
        XCHG
        RET

; HL = slot of line A, of 16 bytes (32), from page D on.
SLOT16: MOV     L,A
        MVI     H,0
        JMP     SLOT1
SLOT32: MOV     L,A
        MVI     H,0
        DAD     H
SLOT1:  DAD     H
        DAD     H
        DAD     H
        DAD     H
        MOV     A,H
        ADD     D
        MOV     H,A
        RET

        IF      COVER
LAYERS: DB      0               ; not 0: lists of columns and layers, in slots of 48 bytes
SLOTN:  DW      0               ; bytes in a slot of a face

; The same with slots of 48 (96) bytes.
SLOT48: PUSH    D
        MVI     D,0
        CALL    SLOT16
        MOV     D,H
        MOV     E,L
        DAD     H
        DAD     D
        POP     D
SLOT2:  MOV     A,H
        ADD     D
        MOV     H,A
        RET
SLOT96: PUSH    D
        MVI     D,0
        CALL    SLOT48
        DAD     H
        POP     D
        JMP     SLOT2

; The same with the slots of a face. DE = SLOTN = their size.
SLOTF:  MOV     E,A
        LDA     LAYERS
        ORA     A
        MOV     A,E
        JNZ     SLOTF1
        CALL    SLOT16
        LXI     D,16
        JMP     SLOTF2
SLOTF1: CALL    SLOT48
        LXI     D,48
SLOTF2: XCHG
        SHLD    SLOTN
        XCHG
        RET
        ENDIF

; The stripes of face A into the slots at BASEH.
BUILD:  STA     FACE
        CALL    EXTOF
        LXI     D,ELINES
        DAD     D
        MOV     B,M
        INX     H
        MOV     C,M
        INX     H
        MOV     E,M
        INX     H
        MOV     D,M
        PUSH    D               ; the shape
        MOV     L,B
        MOV     H,C
        SHLD    YLO             ; and YHI
        LDA     BASEH
        MOV     D,A
        MOV     A,C
        SUB     B
        MOV     C,A             ; lines
        MOV     A,B
        IF      COVER
        CALL    SLOTF
        ELSE
        CALL    SLOT16
        ENDIF
        POP     D
        MOV     A,C
        ORA     A
        RZ
        IF      COVER
        PUSH    D
        XCHG
        LHLD    SLOTN
        XCHG
        ELSE
        LDA     MODE
        ANI     STRIPE
        JNZ     COPY1
        PUSH    D
        LXI     D,16
        ENDIF
BUILD1: MVI     M,255
        DAD     D
        DCR     C
        JNZ     BUILD1
        POP     H
        MOV     A,M
        STA     RINGS
        INX     H
BUILD2: MOV     A,M
        STA     VERTS
        INX     H
        SHLD    FIRSTV
BUILD3: PUSH    H
        LXI     D,6
        DAD     D
        PUSH    H               ; the next vertex, or what follows the ring
        LDA     VERTS
        DCR     A
        STA     VERTS
        JNZ     BUILD4
        LHLD    FIRSTV
BUILD4: XCHG
        POP     H
        XTHL
        CALL    EDGE
        POP     H
        LDA     VERTS
        ORA     A
        JNZ     BUILD3
        LDA     RINGS
        DCR     A
        STA     RINGS
        JNZ     BUILD2
        RET

        IF      1-COVER
; C lists from DE into the slots at HL.
COPY1:  LDAX    D
        INX     D
        MOV     M,A
        INX     H
        INR     A
        JNZ     COPY1
        DCX     H               ; the next slot, also after a full one
        MOV     A,L
        ORI     15
        MOV     L,A
        INX     H
        DCR     C
        JNZ     COPY1
        RET
        ENDIF

; The vertex at HL: BC = X, A = its line.
VERTEX: MOV     C,M
        INX     H
        MOV     B,M
        INX     H
        JMP     LINEOF

; The sides of the edge between the vertices at HL and DE.
EDGE:   CALL    VERTEX
        STA     LY0
        PUSH    B
        XCHG
        CALL    VERTEX
        POP     D               ; DE = X of one, BC of the other, L its line
        MOV     L,A
        LDA     LY0
        CMP     L
        RZ
        JC      EDGE1
        MOV     H,A             ; the other is the lower one
        MOV     A,L
        STA     LY0
        MOV     L,H
        PUSH    B
        PUSH    D
        POP     B
        POP     D
EDGE1:  LDA     LY0
        MOV     H,A
        MOV     A,L
        SUB     H
        STA     DY
        MOV     A,C
        SUB     E
        MOV     L,A
        MOV     A,B
        SBB     D
        MOV     H,A
        SBB     A
        STA     SIGN
        PUSH    D               ; X0
        JZ      EDGE2
        XRA     A
        SUB     L
        MOV     L,A
        MVI     A,0
        SBB     H
        MOV     H,A
EDGE2:  LDA     DY              ; H:L:C = HL * 256 / DY, remainder in E
        MOV     D,A
        LXI     B,1800H
        MVI     E,0
EDGE3:  MOV     A,C
        ADD     A
        MOV     C,A
        MOV     A,L
        RAL
        MOV     L,A
        MOV     A,H
        RAL
        MOV     H,A
        MOV     A,E
        RAL
        JC      EDGE4
        CMP     D
        JC      EDGE5
EDGE4:  SUB     D
        INR     C
EDGE5:  MOV     E,A
        DCR     B
        JNZ     EDGE3
        MOV     B,H             ; B:DE = a line's step
        MOV     D,L
        MOV     E,C
        IF      COVER
        LDA     LAYERS
        ORA     A
        CNZ     SPREAD
        ENDIF
        MOV     A,B             ; C:HL = half of it
        ORA     A
        RAR
        MOV     C,A
        MOV     A,D
        RAR
        MOV     H,A
        MOV     A,E
        RAR
        MOV     L,A
        LDA     SIGN
        ORA     A
        JZ      EDGE6
        XRA     A
        SUB     E
        MOV     E,A
        MVI     A,0
        SBB     D
        MOV     D,A
        MVI     A,0
        SBB     B
        MOV     B,A
        XRA     A
        SUB     L
        MOV     L,A
        MVI     A,0
        SBB     H
        MOV     H,A
        MVI     A,0
        SBB     C
        MOV     C,A
EDGE6:  SHLD    HALF            ; C:HL = X0 + half a step + 7FFF
        POP     H
        MOV     A,H
        ADD     C
        MOV     C,A
        LDA     HALF
        ADI     0FFH
        PUSH    PSW
        LDA     HALF+1
        JNC     EDGE7
        ADI     1
        JNC     EDGE7
        INR     C
EDGE7:  ADI     7FH
        JNC     EDGE8
        INR     C
EDGE8:  ADD     L
        JNC     EDGE9
        INR     C
EDGE9:  MOV     H,A
        POP     PSW
        MOV     L,A
        PUSH    D
        PUSH    H
        LDA     BASEH
        MOV     D,A
        LDA     LY0
        IF      COVER
        CALL    SLOTF
        ELSE
        CALL    SLOT16
        ENDIF
        SHLD    SLOT
        POP     H
        POP     D
EDGE10: PUSH    D               ; C:HL is at the middle of the line
        PUSH    H
        PUSH    B
        IF      COVER
        CALL    SIDE4
        LHLD    SLOTN
        XCHG
        LHLD    SLOT
        ELSE
        MOV     B,C
        LHLD    SLOT
        CALL    INSERT
        LHLD    SLOT
        LXI     D,16
        ENDIF
        DAD     D
        SHLD    SLOT
        POP     B
        LXI     H,DY
        DCR     M
        POP     H
        POP     D
        RZ
        DAD     D
        MOV     A,C
        ADC     B
        MOV     C,A
        JMP     EDGE10

; Toggle B into the list in the slot at HL.
INSERT: MOV     A,B
        CPI     255
        RZ
INSER1: CMP     M
        JZ      INSER3
        JC      INSER2
        INX     H
        JMP     INSER1
INSER2: MOV     A,M             ; before the first greater one
        MOV     M,B
        MOV     B,A
        INX     H
        INR     A
        JNZ     INSER2
        MOV     A,L
        ANI     15
        JZ      OVERF
        MVI     M,255
        RET
INSER3: INX     H               ; it is there: out
        MOV     A,M
        DCX     H
        MOV     M,A
        INX     H
        INR     A
        JNZ     INSER3
        RET
