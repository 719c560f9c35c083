/ Tape 2: the search along the avenues of sight

/ One pass: one eye, one window.
/ In: pex ey ez pjw wxlo wxhi cx2, scene tape, a file begun by newfil.
/ Out: the file has the visible lines of the pass.
/ Destroys: 10-16, the stack and all variables of tapes 2 to 7; leaves by fault
/   on an error.
onepas, 0
        lac pex
        cma
        tad (1
        dac nex
        lac ey
        cma
        tad (1
        dac ney
        IFZERO ROTATE <
        lac ez
        >
        IFNZRO ROTATE <
        lac pez
        >
        cma
        tad (1
        dac nez
        jms setbnd
        jms forget
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
        lac i 10
        and (17777
        sza
        jmp opnext
        jmp oplast      / a cell without openings

/ Back in a cell: has it openings that are not examined yet?
opback, lac i lp
        spa
        jmp oplast

opnext, isz lp
        lac i lp
        and (17777
        dac elem
        lac i elem
        spa
        jmp oplow
        lac (1          / N=0: the far cell is on the high side
        dac tolow
        lac elem
        tad (1
        jmp opset
oplow,  lac (40000
        dac tolow
        lac elem
        tad (2
opset,  dac org         / the opening's X word, and its name
        sad entry
        jmp opback      / the way we came in

/ Test an opening.  What is known of it holds for the whole pass, and is kept
/ in a record found by its address: no two openings begin in the same eight
/ words.  First word: 1 or 40000, the eye is before its plane looking to the
/ high or to the low side; 4, it has a real line; 10, known.  Then its box on
/ the screen.
opens,  lac org
        IFNZRO WALK <
        tad (-10+1      / with WALK the record is before the opening
        dac 15
        >
        IFZERO WALK <
        tad (-scene+1
        rcr
        and (377774     / four words for each eight,
        dac t1
        rcr
        rcr             / and a fifth
        tad t1
        tad (recs-1
        dac 15
        tad (-recend+2
        sma
        jms beyond
        >
        lac i 15
        sna
        jms newrec
        dac t1
        and tolow
        dac crossf      / nonzero: the eye may look through
        sza
        jmp opbox
        lac t1
        and (4
        sna
        jmp opback      / neither a way nor a line
opbox,  lac i 15        / apart from the mask: nothing can be seen
        dac bxlo
        cma
        tad xhi1
        spa
        jmp opback
        lac i 15
        dac bxhi
        tad nxlo
        spa
        jmp opback
        lac i 15
        dac bylo
        cma
        tad yhi1
        spa
        jmp opback
        lac i 15
        dac byhi
        tad nylo
        spa
        jmp opback
        lac crossf
        sza
        jmp crossb

/ The eye does not look through: only the lines of the outline matter.
        dzm ringf
        lac org
        tad (777777
        dac 10
        jms chain
        jmp opback

/ The eye may look through: outline and polygon together.
crossb, jms plane
        IFZERO ROTATE <
        IFNZRO EAE <
        lac rectf
        sza
        jmp crosbp      / tried as a box, to no avail
        lac nring
        sad (4
        lac ucell
        sza
        jmp crosbp

/ A rectangle across k is its box on the screen: if no sloped edge of the mask
/ cuts it, so is what is left of it, and no polygon is needed.  (Without the EAE
/ core is too full for this.)
        lac nring
        dac pn
        dac rectf
        dzm revers
        jms isect
        dzm rectf
        dac pn          / 0: nothing is left
        dzm ringf
        lac org
        tad (777777
        dac 10
        jms chain
        lac pn
        sna
        jmp opback
        jms stackm
        jms setbox
        dzm nslope
        jmp descnd
crosbr, lac org         / a sloped edge cuts it: begin again
        jmp opens+1
        >
        >

crosbp, dzm rectf
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
        jmp crosz
        sad (600000     / k to i
        jmp crosz
        lac revers
        xor (40000
        dac revers
crosz=.
        IFZERO ROTATE <
        lac r
        jms zleast      / the least z at which the plane is in the bound
        dac zh
        cma
        tad (1
        dac nzh
        clc
        dac ringf
        lac (polq-1
        dac palt
        lac (poly-1
        dac pcur
        dac 11
        jms newpol
        lac org
        tad (777777
        dac 10
        jms chain
        lac pcur
        jms wrap
        >
        IFNZRO ROTATE <
        jms outlin
        >
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
        lac i elem
        and (17777
        dac cell
        jmp visit

/ The opening's plane: its first vectors along two axes, and the plane's place
/ on the third as seen from the eye.
/ In: org.
/ Out: nring vec1 vec2 axis1 axis2 ucell r.
/ Destroys: 15 cnt t1; leaves by flt6 if a ring lies along one axis.
plane,  0
        lac org
        tad (2
        dac 15
        lac i 15
        dac nring
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
plnext, isz cnt
        skp
        jmp flt6        / all along one axis
        lac i 15
        dac vec2
        and (300000
        sna
        jmp flt6
        sad axis1
        jmp plnext
        dac axis2
        tad axis1
        sad (300000
        jmp plnk
        sad (400000
        jmp plnj
        lac (py         / across i
        dac ucell
        lac i org
        tad nex
        dac r
        jmp i plane
plnj,   lac (px         / across j
        dac ucell
        lac org
        tad (1
        dac t1
        lac i t1
        tad ney
        dac r
        jmp i plane
plnk,   dzm ucell       / across k
        lac org
        tad (2
        dac t1
        lac i t1
        tad nez
        dac r
        IFZERO ROTATE <
        sma
        jmp i plane
        dzm r           / nothing is seen towards the back
        >
        jmp i plane

        IFZERO WALK <
/ An opening beyond the table is worked out every time.
/ Out: 15 before the record at recend, which is empty.  Destroys: nothing else.
beyond, 0
        lac (recend-1
        dac 15
        dzm recend
        jmp i beyond
        >

/ Make the record of an opening, whose first word 15 points at: AC = that word.
/ In: 15 at the record, org.
/ Out: AC = its first word, 15 as before, the record, and what plane returns.
/ Destroys: cnt t1 vecw rec pz bound bxlo bxhi bylo byhi, what proj destroys.
newrec, 0
        lac 15
        dac rec
        jms plane
        IFNZRO WALK <
        IFZERO ROTATE <
        jms extent
        >
        jmp recsiz
/ ext = how far an opening extends from the eye along each axis.
/ In: org, axis1 axis2 of plane.  Out: ext.  Destroys: 15 vecw exaxis excell exsum.
extent, 0
        >
        lac org         / the ends of its extent along each axis
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
        lac i 15
        lac i 15
        dac vecw
        lac axis1       / a rectangle: one side, then the next
        jms extend
        lac axis2
        jms extend
        IFNZRO WALK <
        jmp i extent
        >
recsiz, lac (10
        dac i rec
        IFNZRO ROTATE <
        lac (377777     / its outline, with no line drawn
        dac vmask
        jms outlin
        clc
        dac vmask
        lac pn
        sna
        jmp nrdone      / all of it beside the view
        jms box
        >
        IFZERO ROTATE <
        lac ext+5
        tad (777777
        spa
        jmp nrdone      / all of it behind the eye
        lac ext+4
        tad (777777
        sma
        jmp nrnear
        lac (1
        dac ext+4
nrnear, lac ext+4       / seen largest at the nearest z
        dac pz
        jms newz
        lac ext
        sma
        jmp nrnxhi
        jms clproj
        dac bxlo
nrnxhi, lac ext+1
        spa
        jmp nrnylo
        jms clproj
        dac bxhi
nrnylo, lac ext+2
        sma
        jmp nrnyhi
        jms clproj
        dac bylo
nrnyhi, lac ext+3
        spa
        jmp nrfar
        jms clproj
        dac byhi
nrfar,  lac ext+5       / and smallest at the farthest
        dac pz
        jms newz
        lac ext
        spa
        jmp nrfxhi
        jms clproj
        dac bxlo
nrfxhi, lac ext+1
        sma
        jmp nrfylo
        jms clproj
        dac bxhi
nrfylo, lac ext+2
        spa
        jmp nrfyhi
        jms clproj
        dac bylo
nrfyhi, lac ext+3
        sma
        jmp nrstor
        jms clproj
        dac byhi
        >
nrstor, lac rec
        dac 15
        lac bxlo
        dac i 15
        lac bxhi
        dac i 15
        lac bylo
        dac i 15
        lac byhi
        dac i 15
        lac r
        sna
        jmp nrline
        spa
        jmp nrdown
        isz i rec       / beyond the eye: to be crossed upwards
        jmp nrline
nrdown, lac i rec
        tad (40000
        dac i rec
nrline, lac org         / a real line?
        tad (3
        dac 15
        lac nring
        cma
        tad (1
        dac cnt
nreach, lac i 15
        spa
        jmp nrreal
        isz cnt
        jmp nreach
        jmp nrdone
nrreal, lac i rec
        tad (4
        dac i rec
nrdone, lac rec
        dac 15
        lac i rec
        jmp i newrec

        IFZERO ROTATE <
/ In: AC, bound and divisor by newz.
/ Out: AC, projected from within the bound.
/ Destroys: t1, what proj destroys.
clproj, 0
        jms clamp
        jms proj
        jmp i clproj
        >

/ In: AC = axis, vecw = a vector of the run, 15 at it.
/ Out: ext; vecw and 15: the vector after the run.
/ Destroys: nothing else.
extend, 0               / extend the extent by a run of vectors along axis AC
        dac exaxis
        cll
        rtl
        rtl
        rcl
        tad (ext-2
        dac excell
        dzm exsum
exnext, lac vecw
        and (300000
        sad exaxis
        skp
        jmp exdone
        lac vecw
        and (77777
        xor (40000
        tad (740000
        tad exsum
        dac exsum
        lac i 15
        dac vecw
        jmp exnext
exdone, lac exsum
        sma
        isz excell
        tad i excell
        dac i excell
        jmp i extend

/ Forget all records: a pass begins.
/ Out: the records are zero.  Destroys: rec cnt.
forget, 0
        IFNZRO WALK <
        lac (ways       / only a scene tape for the walk has this tag
fgopn,  dac rec         / from opening to opening, up to the planes of cell 0
        tad (-c0+4
        sma
        jmp i forget
        dzm i rec
        lac rec
        tad (12
        dac t1
        lac i t1
        tad t1
        tad (1
        jmp fgopn
        >
        IFZERO WALK <
        lac (recs
        dac rec
        lac (-recmax+1
        dac cnt
fgnext, dzm i rec
        lac rec
        tad (5
        dac rec
        isz cnt
        jmp fgnext
        jmp i forget
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
/ In: the mask, sp.
/ Out: the mask at sp, spnew = the first word after it.
/ Destroys: 15 16 cnt.
stackm, 0
        lac (maskw-1
        dac 15
        lac sp
        tad (777777
        dac 16
        lac nslope
        jms copy
        lac 16
        tad (1
        dac spnew
        jmp i stackm

/ In: sp.  Out: the mask.  Destroys: 15 16 cnt.
unstak, 0               / the mask at sp is the current one again
        lac sp
        tad (777777
        dac 15
        lac (maskw-1
        dac 16
        lac i sp
        jms copy
        jmp i unstak

/ In: AC, 15, 16.  Out: 15 and 16 at the last words.  Destroys: cnt.
copy,   0               / a mask of -AC sloped edges from 15 to 16
        rcl
        rcl
        dac cnt
        lac i 15        / the count and the box
        dac i 16
        lac i 15
        dac i 16
        lac i 15
        dac i 16
        lac i 15
        dac i 16
        lac i 15
        dac i 16
        lac cnt
        sna
        jmp i copy
cpedge, lac i 15        / the edges
        dac i 16
        isz cnt
        jmp cpedge
        jmp i copy

/ In: sp spnew lp entry cell.
/ Out: sp = the first free word.
/ Destroys: 16 t1; leaves by flt1 if the stack is full.
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
org,    0
tolow,  0               / far cell on the low side 40000, on the high side 1
vec1,   0
vec2,   0
axis1,  0
axis2,  0
revers, 0               / the ring runs clockwise on the screen
ringf,  0               / nonzero: collect the outline as a polygon
r,      0               / the opening's plane as seen from the eye
zh,     0               / the opening's least z in the bound, and minus it
nzh,    0
ucell,  0               / the coordinate that varies along the plane; 0: across k
rectf,  0               / nonzero: isect has a box only, no polygon
rec,    0               / the opening's record
crossf, 0
nring,  0
ext,    0               / extent of an opening from the eye: x, y, z, low and high
        0
        0
        0
        0
        0
exaxis, 0
excell, 0
exsum,  0
sp,     0               / first free word of the stack
spnew,  0
cnt,    0
t1,     0
