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
nocr2,
        IFNZRO EAE <
        jms unseen
        sza
        jmp opback
        >
        dzm ringf
        lac org
        tad (777777
        dac 10
        jms chain
        jmp opback

/ The eye may look through: outline and polygon together.
crossb,
        IFNZRO EAE <
        jms unseen
        sza
        jmp opback
        >
        lac vec1
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
        lac (polq-1
        dac palt
        lac (poly-1
        dac pcur
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
        jms stackm      / the current mask, for the way back
        jms newmsk
        lac nslope
        sna
        jmp descnd
        jms area2
        sza
        jmp descnd
        jms unstak      / a sliver without area is no mask
        jmp opback
descnd, lac depth
        sad scene+1
        jmp flt5
        jms push
        lac org
        dac entry
        lac nxcell
        dac cell
        jmp visit

        IFNZRO EAE <
/ AC nonzero if the opening cannot be seen through the mask's box: it lies
/ behind the near plane, or beyond one of the four sides by a half point or
/ more.  The answer only saves work: nothing would be drawn.  A multiplication
/ takes 6 us here; without the EAE it would cost more than it saves.
unseen, 0
        lac org
        tad (777777
        dac 15
        lac i 15
        tad nex
        dac ext
        dac ext+1
        lac i 15
        tad ney
        dac ext+2
        dac ext+3
        lac i 15
        tad nez
        dac ext+4
        dac ext+5
        lac i 15        / n
        lac i 15
        dac vecw
        lac axis1       / the rectangle: one side, then the next
        jms extend
        lac axis2
        jms extend
        lac ext+5
        tad (777770
        spa
        jmp unsee1
        lac ext+4
        tad (777770
        sma
        jmp unsee2
        lac (10
        dac ext+4
unsee2, lac nxlo        / right end left of xlo
        cma
        dac bynd
        lac ext+1
        jms beyond
        lac xhi1        / left end right of xhi
        cma
        tad (1
        dac bynd
        lac ext
        cma
        tad (1
        jms beyond
        lac nylo
        cma
        dac bynd
        lac ext+3
        jms beyond
        lac yhi1
        cma
        tad (1
        dac bynd
        lac ext+2
        cma
        tad (1
        jms beyond
        lac (0
        jmp i unseen
unsee1, clc
        jmp i unseen

extend, 0               / extend the box by a run of vectors along axis AC
        dac exaxis
        cll
        rtl
        rtl
        rcl
        tad (ext-2
        dac excell
        dzm exsum
exten1, lac vecw
        and (300000
        sad exaxis
        skp
        jmp exten2
        lac vecw
        and (77777
        xor (40000
        tad (740000
        tad exsum
        dac exsum
        lac i 15
        dac vecw
        jmp exten1
exten2, lac exsum
        sma
        isz excell
        tad i excell
        dac i excell
        jmp i extend

/ Is AC*W < bynd*z at every z of the opening?  If so it is unseen.
beyond, 0
        dac bya
        lac bynd
        spa
        jmp beyon1
        lac bya         / bynd >= 0: the nearest z
        spa
        jmp unsee1
        cll
        mul
bw1,    0
        dac byh
        lacq
        dac byl
        lac ext+4
        dac bz1
        lac bynd
        cll
        mul
bz1,    0
        dac byh2
        lacq
        dac byl2
        jmp beyon2
beyon1, lac bya         / bynd < 0: the farthest z
        sma
        jmp i beyond
        cma
        tad (1
        cll
        mul
bw2,    0
        dac byh2
        lacq
        dac byl2
        lac ext+5
        dac bz2
        lac bynd
        cma
        tad (1
        cll
        mul
bz2,    0
        dac byh
        lacq
        dac byl
beyon2, lac byl2        / byh,byl < byh2,byl2 ?
        cma
        cll
        tad (1
        tad byl         / L: no borrow
        lac byh2
        cma
        szl
        tad (1
        tad byh
        spa
        jmp unsee1
        jmp i beyond
        >

/ No opening left: ascend a level.
oplast, lac depth
        tad (777777
        dac depth
        sna
        jmp i onepas
        lac sp          / pop
        tad (777773
        dac 16
        lac i 16
        dac sp
        lac i 16
        dac lp
        lac i 16
        dac entry
        lac i 16
        dac cell
        jms unstak
        jmp opback

/ The stack holds a mask (its count, its box, its sloped edges), then where the
/ search stands: place in the list, entry and cell.  One word ties the frames.
stackm, 0
        lac sp
        tad (777777
        dac 16
        lac (maskw-1
        dac 15
        lac nslope
        rcl
        rcl
        tad (-5+1
        dac cnt
stack1, lac i 15
        dac i 16
        isz cnt
        jmp stack1
        lac 16
        tad (1
        dac spnew
        jmp i stackm

unstak, 0               / the mask at sp is the current one again
        lac sp
        tad (777777
        dac 15
        lac (maskw-1
        dac 16
        lac i sp
        rcl
        rcl
        tad (-5+1
        dac cnt
unsta1, lac i 15
        dac i 16
        isz cnt
        jmp unsta1
        jmp i unstak

push,   0               / the rest of the frame, behind the mask
        lac spnew
        tad (4
        dac t1
        tad (-stkend+1
        sma sza
        jmp flt1
        lac spnew
        tad (777777
        dac 16
        lac sp
        dac i 16
        lac lp
        dac i 16
        lac entry
        dac i 16
        lac cell
        dac i 16
        lac t1
        dac sp
        jmp i push

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
        IFNZRO EAE <
ext,    0               / box of an opening from the eye: x, y, z, low and high
        0
        0
        0
        0
        0
exaxis, 0
excell, 0
exsum,  0
bynd,   0
bya,    0
byh,    0
byl,    0
byh2,   0
byl2,   0
        >
sp,     0               / first free word of the stack
spnew,  0
cnt,    0
t1,     0
