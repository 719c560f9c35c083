; Ports, commands and status bits of the devices that more than one program drives, and the status they share. What only one
; program uses is in its own equates.asm.

; ---- EF9365 raster board
GDPCMD  EQU     40H             ; command; read: status
GDPCT1  EQU     41H
GDPXH   EQU     48H
GDPX    EQU     49H
GDPYH   EQU     4AH
GDPY    EQU     4BH
GDPCOL  EQU     50H             ; colour latch
GDPRDY  EQU     04H             ; status: ready
CLEAR   EQU     04H             ; command
PENON   EQU     03H             ; CTRL1: pen down, writing

; ---- CalComp 565
CALCMD  EQU     60H             ; command; read: status
CALERR  EQU     80H
CALUP   EQU     08H
CALDN   EQU     09H

; ---- Parallel link to the host: 8255, port A strobed in
PARDAT  EQU     0E4H
PARSTA  EQU     0E6H
PARCTL  EQU     0E7H
PARIBF  EQU     20H
PARMOD  EQU     0B0H            ; group A mode 1, port A in

; ---- Status at the end
COMPLT  EQU     1
