; Where everything is: memory, the ports that no other program uses (../ports.asm has the rest), the layout of records and tables.

; ---- Memory. The program is below FS. Lists of a line are in slots of a fixed size, so that a line's list is found by a shift.
        IF      COVER
FS      EQU     1000H           ; stripes of the face at hand: 48 bytes a line, pairs of column and layers that change there
VS      EQU     4000H           ; the same of a second face
SS      EQU     7000H           ; silhouette: 96 bytes a line, see cover.asm; before it is begun, the matrix of relations
SCENE   EQU     0D000H          ; the body as received
SCNMAX  EQU     2800H           ; its greatest length
UBUF    EQU     0F800H          ; a line that is being made, up to 256 bytes
T1      EQU     0F840H          ; a line of a first difference
VTOP    EQU     0F900H          ; below it a line of a difference, as in the other builds
        ELSE
FS      EQU     1000H           ; stripes of the face at hand: 16 bytes a line
VS      EQU     2000H           ; its visible part: 32 bytes per line, pairs of toggle and mark; also stripes of a second face
SS      EQU     4000H           ; silhouette: 32 bytes a line; before it is begun, the matrix of relations
SCENE   EQU     6000H           ; the body as received
SCNMAX  EQU     6800H           ; its greatest length
UBUF    EQU     0C800H          ; a line of a union
T1      EQU     0C840H          ; a line of a first difference
VTOP    EQU     0C900H          ; below it a line of a difference, downwards, two bytes each, the upper one the toggle
        ENDIF
EXT     EQU     VTOP            ; 16 bytes a face, see below
FACEP   EQU     VTOP+400H       ; address of each record
ORDER   EQU     VTOP+480H       ; the priority list; no entry of a table of faces may be in another page than its first
SORT    EQU     VTOP+4C0H       ; faces by least X
NMIN    EQU     VTOP+500H       ; how many faces each hides
NMAX    EQU     VTOP+540H       ; how many hide each
GONE    EQU     VTOP+580H       ; 0 left, 1 leaves to the front, 2 to the back, 3 gone
CUTS    EQU     VTOP+600H       ; pairs: face, what it is cut by
STACK   EQU     VTOP+700H

MOSTF   EQU     64
MOSTC   EQU     63

; ---- An entry of EXT: words of least and greatest X, Y, Z; line of the lowest, behind the highest; address of the shape
ELINES  EQU     12

; ---- A record: length, level, plane (a, b, c, d), rings
RPLANE  EQU     3
RRINGS  EQU     13

; ---- Bits of MODE
VECTOR  EQU     1
PRIOR   EQU     2
STRIPE  EQU     4

; ---- EF9365 raster board
GDPCT2  EQU     42H
GDPDX   EQU     45H
GDPDY   EQU     47H
EAST    EQU     10H             ; a vector of DELTAX to the right

; ---- Status at the end
NOTSTR  EQU     2
SILENT  EQU     3
BADSUM  EQU     4
TOOBIG  EQU     5
BADREC  EQU     6
FULL    EQU     7
ABSENT  EQU     8
DEVERR  EQU     9
