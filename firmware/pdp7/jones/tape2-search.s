/ Tape 2: the search along the avenues of sight

/ One pass: one eye, one window.
onepas, 0
        lac pex
        cma
        tad (1
        dac nex
        lac ey
        cma
        tad (1
        dac ney
        lac ez
        cma
        tad (1
        dac nez
        jms setbnd
        jms winmsk
        lac (stack
        dac sp
        dzm depth
        dzm entry
        lac scene
        dac cell

/ Visual access to a cell has been gained: cell, mask and entry are set.
visit,  isz depth
        lac cell
        tad (777777
        dac 10
        dzm ringf
        jms chain       / its lines, through the mask
        lac 10
        dac lp          / the word before its list of openings
        jmp opnext

/ Back in a cell: has it openings that are not examined yet?
opback, lac i lp
        spa
        jmp oplast

opnext, lac lp
        tad (1
        dac lp
        lac i lp
        and (17777
        sna
        jmp oplast      / a cell without openings
        dac elem
        lac i elem
        and (17777
        dac nxcell
        lac i elem
        spa
        jmp opn1
        dzm tolow       / N=0: the far cell is on the high side
        lac elem
        tad (1
        jmp opn2
opn1,   lac (40000
        dac tolow
        lac elem
        tad (2
opn2,   dac org         / the opening's X word, and its name
        sad entry
        jmp opback      / the way we came in

/ Test an opening: its plane, and on which side of it the eye is.
opens,  lac org
        tad (2
        dac 15
        lac i 15
        cma
        tad (1
        sna
        jmp flt6
        dac cnt
        lac i 15
        dac vec1
        and (300000
        sna
        jmp flt6
        dac axis1
scan,   isz cnt
        skp
        jmp flt6        / all along one axis
        lac i 15
        dac vec2
        and (300000
        sna
        jmp flt6
        sad axis1
        jmp scan
        dac axis2
        tad axis1
        sad (300000
        jmp plank
        sad (400000
        jmp planj
        lac (py         / plane across i
        dac ucell
        lac i org
        tad nex
        jmp planij
planj,  lac (px         / across j
        dac ucell
        lac org
        tad (1
        dac t1
        lac i t1
        tad ney
planij, dac plane       / the plane, as seen from the eye
        jms zleast      / the least z at which it is in the bound
        dac zh
        lac tolow
        sza
        jmp plan1
        lac plane
        sma sza         / to the high side: it must lie beyond the eye
        jmp crossb
        jmp nocros
plan1,  lac plane
        spa             / to the low side: before it
        jmp crossb
        jmp nocros
plank,  lac (10         / across k: in front, and not nearer than 8
        dac zh
        lac tolow
        sza
        jmp nocros
        lac org
        tad (2
        dac t1
        lac i t1
        tad nez
        tad (777770
        sma
        jmp crossb

/ The eye does not look through: only the lines of the outline matter.
nocros, lac org
        tad (2
        dac 15
        lac i 15
        cma
        tad (1
        dac cnt
nocr1,  lac i 15
        spa
        jmp nocr2
        isz cnt
        jmp nocr1
        jmp opback      / none
nocr2,  dzm ringf
        lac org
        tad (777777
        dac 10
        jms chain
        jmp opback

/ The eye may look through: outline and polygon together.
crossb, lac vec1
        xor vec2
        xor tolow
        and (40000
        dac revers
        lac axis1
        cma
        tad (1
        tad axis2
        sad (100000     / i to j, j to k
        jmp cross1
        sad (600000     / k to i
        jmp cross1
        lac revers
        xor (40000
        dac revers
cross1, clc
        dac ringf
        lac (poly-1
        dac 11
        dzm pn
        lac org
        tad (777777
        dac 10
        jms chain
        jms wrap
        lac pn
        tad (777775
        spa
        jmp opback
        jms isect
        sna
        jmp opback      / empty: the opening is not visible

/ Access to the far cell: descend a level.
        lac depth
        sad scene+1
        jmp flt5
        jms push
        jms newmsk
        lac org
        dac entry
        lac nxcell
        dac cell
        jmp visit

/ No opening left: ascend a level.
oplast, lac depth
        tad (777777
        dac depth
        sna
        jmp i onepas
        jms pop
        jmp opback

/ The stack: vertices of the mask, place in the list, entry, cell, n.
push,   0
        lac mn
        rcl
        tad (4
        tad sp
        tad (-stkend+1
        sma sza
        jmp flt1
        lac sp
        tad (777777
        dac 16
        lac (mask-1
        dac 15
        lac mn
        rcl
        cma
        tad (1
        dac cnt
push1,  lac i 15
        dac i 16
        isz cnt
        jmp push1
        lac lp
        dac i 16
        lac entry
        dac i 16
        lac cell
        dac i 16
        lac mn
        dac i 16
        lac 16
        tad (1
        dac sp
        jmp i push

pop,    0
        lac sp
        tad (777777
        dac t1
        lac i t1
        dac mn
        rcl
        cma
        tad (1
        dac cnt
        tad (-4+1
        tad sp
        dac sp          / sp - 2n - 4
        tad (777777
        dac 15
        lac (mask-1
        dac 16
pop1,   lac i 15
        dac i 16
        isz cnt
        jmp pop1
        lac i 15
        dac lp
        lac i 15
        dac entry
        lac i 15
        dac cell
        jms mskbox
        jmp i pop

depth,  0
cell,   0
entry,  0               / the opening by which the cell was entered
lp,     0               / place in the cell's list of openings
elem,   0
nxcell, 0
org,    0
tolow,  0               / 40000: the far cell is on the low side
vec1,   0
vec2,   0
axis1,  0
axis2,  0
revers, 0               / the ring runs clockwise on the screen
ringf,  0               / nonzero: collect the outline as a polygon
plane,  0
zh,     0               / the opening's least z in the bound
ucell,  0               / the coordinate that varies along the plane
sp,     0
cnt,    0
t1,     0
