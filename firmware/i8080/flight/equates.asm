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
        IF      FACING
FACE    EQU     2200H           ; by number: 1 if the piece faces the eye, 0 if not; FF before its entry has come
; Lists of numbers like LIST, each in a page that it fills from the end. The first byte is the place of the first number, 0 of none.
FIXED   EQU     2300H           ; the points that are no pieces
NEW     EQU     2400H           ; pieces that have come to face the eye in this frame, the first found last
AWAY    EQU     2500H           ; pieces that have turned away, likewise
PLACEL  EQU     2600H           ; by number: the address of its coordinates if they are words, the low half
PLACEH  EQU     2700H           ; the high half
REACHED EQU     2800H           ; by direction: the address of the entry that its value would pass next
MORE    EQU     2900H           ; the program's second part
ENTRIES EQU     2E00H           ; of each direction a sentinel and its entries, then one more sentinel; five bytes each
        ENDIF
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
        IF      FACING
FACEP   EQU     FACE SHR 8
NEWP    EQU     NEW SHR 8
AWAYP   EQU     AWAY SHR 8
PLACEP  EQU     PLACEL SHR 8
        ENDIF

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
