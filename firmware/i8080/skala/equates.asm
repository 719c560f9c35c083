; Where everything is: memory pages, the ports that no other program uses (../ports.asm has the rest), and the codes of the
; instructions the step engine is patched with.

; ---- Memory. All masks are whole pages, so that a column's entry is found by loading a page number into H.
MT      EQU     1900H           ; mask top: the highest row drawn so far in each column
MB      EQU     1A00H           ; mask bottom
MP      EQU     1B00H           ; row of the previous slice in each column
IP      EQU     1C00H           ; level of the previous slice, 0 for none
LOWT    EQU     1D00H           ; LT - 1: below the lower end of what last raised the top, 0 for nothing to fold
HIGHB   EQU     1E00H           ; HB + 1: above the upper end of what last lowered the bottom, 255 for nothing to fold
SCR0    EQU     1F00H           ; written and never read (lines.asm); the stack's page too: empty when a line begins
BUFFER  EQU     2000H           ; commands as received; the stack starts below it
BUFEND  EQU     0E000H
SLACK   EQU     800             ; less than this free: draw what is buffered (the longest command has 770 bytes)

MTP     EQU     MT SHR 8
MBP     EQU     MB SHR 8
MPP     EQU     MP SHR 8
IPP     EQU     IP SHR 8
LTP     EQU     LOWT SHR 8
HBP     EQU     HIGHB SHR 8
S0P     EQU     SCR0 SHR 8
S1P     EQU     LTP             ; as SCR0: the loops that write there draw only without silhouettes
S2P     EQU     HBP

; ---- EF9365 raster board
DOT     EQU     80H             ; command: a vector of length nothing

; ---- ALT-256 raster board
ALTDAT  EQU     30H             ; colour, and draws; read: status
ALTX    EQU     31H
ALTY    EQU     32H
ALTCLR  EQU     33H             ; erase to this colour
ALTRDY  EQU     80H             ; status: ready

; ---- CalComp 565
CALBSY  EQU     01H

; ---- Minigraf 0507
MINI    EQU     0F0H            ; bits 2-0 phase of x, 5-3 phase of y, 7 pen down

; ---- Serial link to the host
SERDAT  EQU     0ECH            ; 8251
SERCTL  EQU     0EDH
SERMOD  EQU     4EH             ; 8 bits, no parity, 1 stop bit, clock times 16
SERRST  EQU     37H             ; errors reset, receiver on, RTS
SERRUN  EQU     27H
SERHLD  EQU     07H             ; RTS off: the host should wait
SERRDY  EQU     02H
SERERR  EQU     38H             ; framing, overrun, parity

; ---- Status at the end
UNKNWN  EQU     2
RANGE   EQU     3
LINKER  EQU     4
DEVERR  EQU     5
ABSENT  EQU     6

; ---- Instructions put into the step engine
INRL    EQU     2CH
DCRL    EQU     2DH
INRB    EQU     04H
DCRB    EQU     05H
INRA    EQU     3CH
DCRA    EQU     3DH
