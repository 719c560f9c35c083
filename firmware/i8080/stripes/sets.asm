; The set operations on lists of toggles. Source: SPECIFICATION.md, section 3.
;
; One pass makes a difference and a union. Which of the two lists a column is in is not stored: it is the place in the program. The
; stack pointer writes the difference, so that no toggle costs a call.

MERGEH: DW      0
SAVESP: DW      0

; Lists at HL (A) and DE (B): A - B below VTOP, A or B at UBUF.
MERGE:  SHLD    MERGEH
        LXI     H,0
        DAD     SP
        SHLD    SAVESP
        LHLD    MERGEH
        LXI     SP,VTOP
        LXI     B,UBUF
OUTSID: LDAX    D               ; in neither
        CMP     M
        JC      OUTB
        JZ      OUTAB
        MOV     A,M
        INX     H
        PUSH    PSW
        STAX    B
        INX     B
INA:    LDAX    D               ; in A
        CMP     M
        JC      INAB
        JZ      INAA
        MOV     A,M
        INX     H
        PUSH    PSW
        STAX    B
        INX     B
        JMP     OUTSID
INAB:   INX     D
        PUSH    PSW
INBOTH: LDAX    D               ; in both
        CMP     M
        JC      BOTHB
        JZ      BOTHAB
        INX     H
INB:    LDAX    D               ; in B
        CMP     M
        JC      INBB
        JZ      INBA
        INX     H
        JMP     INBOTH
INBB:   INX     D
        STAX    B
        INX     B
        JMP     OUTSID
INBA:   CPI     255
        JZ      MERGED
        INX     H
        INX     D
        PUSH    PSW
        JMP     INA
BOTHB:  INX     D
        PUSH    PSW
        JMP     INA
BOTHAB: CPI     255
        JZ      MERGED
        INX     H
        INX     D
        STAX    B
        INX     B
        JMP     OUTSID
OUTB:   INX     D
        STAX    B
        INX     B
        JMP     INB
OUTAB:  CPI     255
        JZ      MERGED
        INX     H
        INX     D
        STAX    B
        INX     B
        JMP     INBOTH
INAA:   CPI     255
        JZ      MERGED
        INX     H
        INX     D
        PUSH    PSW
        JMP     INB
MERGED: STAX    B
        PUSH    PSW
        LHLD    SAVESP
        SPHL
        RET

; The difference, as a list, to HL: at most B bytes.
TAKEV:  LXI     D,VTOP-1
TAKEV1: LDAX    D
        DCX     D
        DCX     D
        MOV     M,A
        INX     H
        INR     A
        RZ
        DCR     B
        JNZ     TAKEV1
        JMP     OVERF

; The union to HL: at most B bytes.
TAKEU:  LXI     D,UBUF
TAKEU1: LDAX    D
        INX     D
        MOV     M,A
        INX     H
        INR     A
        RZ
        DCR     B
        JNZ     TAKEU1
        JMP     OVERF

; The lines that the last face built has in common with the one whose lines are in YF: LINE, to before LINEE.
YF:     DW      0
LINE:   DB      0
LINEE:  DB      0
COMMON: LHLD    YLO
        XCHG
        LHLD    YF
        MOV     A,E
        CMP     L
        JNC     COMMO1
        MOV     A,L
COMMO1: STA     LINE
        MOV     A,D
        CMP     H
        JC      COMMO2
        MOV     A,H
COMMO2: STA     LINEE
        RET

; Zero: LINE is after the last of them. Else HL = slot of the face at FS, DE of that at VS.
PAIR:   LXI     H,LINEE
        LDA     LINE
        CMP     M
        JNC     PAIR1
        MVI     D,FS SHR 8
        IF      COVER
        CALL    SLOTF
        ELSE
        CALL    SLOT16
        ENDIF
        MOV     A,H
        ADI     (VS-FS) SHR 8   ; never 0
        MOV     D,A
        MOV     E,L
        RET
PAIR1:  XRA     A
        RET
