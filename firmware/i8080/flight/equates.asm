; Where everything is: memory pages, and the ports that no other program uses (../ports.asm has the rest). A piece is known by its
; number, 1 to 255, which is the low half of the address of all that is kept of it; number 0 is the sentinel of the order.

SQL     EQU     0800H           ; squares of 0..255: low bytes
SQH     EQU     0900H           ; high bytes
XB      EQU     0A00H           ; coordinates that are bytes, by number: x, and in the next two pages y and z
K0      EQU     0D00H           ; keys by number, the high byte first, a page for each byte
K1      EQU     0E00H
K2      EQU     0F00H
K3      EQU     1000H
LIST    EQU     1100H           ; the order: numbers, the nearest piece first, so placed that the last is at 11FF
POINTS  EQU     1200H           ; coordinates that are words: piece after piece, number 1 first
NODES   EQU     1800H           ; per plane its children: before, in, behind
CELL    EQU     1A00H           ; the cell of each piece, by number
NEXT    EQU     1B00H           ; by cell: the priority of its next piece
SIZE    EQU     1C00H           ; by cell: how many pieces
USED    EQU     1D00H           ; by cell or plane: it stands below another plane
STACK   EQU     2100H
SQ4     EQU     8000H           ; squares of -4095..4095, 3 bytes each at SQ4 + 4d, from 4004 to BFFE

SQLP    EQU     SQL SHR 8
SQHP    EQU     SQH SHR 8
XBP     EQU     XB SHR 8
K0P     EQU     K0 SHR 8
K1P     EQU     K1 SHR 8
K2P     EQU     K2 SHR 8
K3P     EQU     K3 SHR 8
LISTP   EQU     LIST SHR 8
SQ4P    EQU     SQ4 SHR 8
CELLP   EQU     CELL SHR 8
NEXTP   EQU     NEXT SHR 8
SIZEP   EQU     SIZE SHR 8
USEDP   EQU     USED SHR 8

; ---- The priority display
PDNUM   EQU     70H             ; number of a piece
PDPRI   EQU     71H             ; its priority
PDCTL   EQU     72H             ; control; read: status
PDWAIT  EQU     02H             ; status: a frame waits to be shown
PDSHOW  EQU     01H             ; control: show it

; ---- Status at the end
NOTFL   EQU     2
RANGE   EQU     3
BADPCS  EQU     4
BADPKT  EQU     5
UNKNWN  EQU     6
SILENT  EQU     7
ABSENT  EQU     8
