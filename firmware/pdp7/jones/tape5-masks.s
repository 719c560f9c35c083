/ Tape 5: masks

/ The first mask of a pass: the window.
winmsk, 0
        lac wxlo
        dac mask
        dac mask+6
        lac wxhi
        dac mask+2
        dac mask+4
        lac (776000     / -1024
        dac mask+1
        dac mask+3
        lac (1776       / 1022
        dac mask+5
        dac mask+7
        lac (4
        dac mn
        jms mskbox
        jmp i winmsk

/ The polygon becomes the current mask.
newmsk, 0
        lac pn
        dac mn
        rcl
        cma
        tad (1
        dac cnt
        lac (poly-1
        dac 15
        lac (mask-1
        dac 16
newms1, lac i 15
        dac i 16
        isz cnt
        jmp newms1
        jms mskbox
        jmp i newmsk

/ Box and sloped edges of the mask.
mskbox, 0
        lac (mask-1
        dac 12
        lac mn
        dac bn
        jms box
        lac bxlo
        cma
        tad (1
        dac nxlo
        lac bxhi
        tad (1
        dac xhi1
        lac bylo
        cma
        tad (1
        dac nylo
        lac byhi
        tad (1
        dac yhi1
        dzm nslope
        lac (slopes-1
        dac 15
        lac (mask-1
        dac 12
        lac mn
        cma
        tad (1
        dac cnt
        lac i 12
        dac lax
        lac i 12
        dac lay
mskb1,  isz cnt
        skp
        jmp mskb3
        lac i 12
        dac lbx
        lac i 12
        dac lby
        jms slope
        jmp mskb1
mskb3,  lac mask        / the last vertex to the first
        dac lbx
        lac mask+1
        dac lby
        jms slope
        jmp i mskbox

/ Add the edge (lax,lay)-(lbx,lby) if it is sloped; b becomes a.
slope,  0
        lac lax
        cma
        tad (1
        dac t1
        tad lbx
        sna
        jmp slope1
        dac t3
        lac lay
        cma
        tad (1
        dac t4
        tad lby
        sna
        jmp slope1
        dac t5
        lac t1
        dac i 15
        lac t4
        dac i 15
        lac t3
        dac i 15
        lac t5
        dac i 15
        lac nslope
        tad (777777
        dac nslope
slope1, lac lbx
        dac lax
        lac lby
        dac lay
        jmp i slope

/ Box bxlo bxhi bylo byhi of bn vertices; 12 before the first.
box,    0
        lac bn
        cma
        tad (1
        dac cnt
        lac i 12
        dac bxlo
        dac bxhi
        lac i 12
        dac bylo
        dac byhi
box1,   isz cnt
        skp
        jmp i box
        lac i 12
        dac t1
        cma
        tad (1
        dac t3
        tad bxlo
        spa
        jmp box2
        lac t1
        dac bxlo
        jmp box3
box2,   lac t3
        tad bxhi
        sma
        jmp box3
        lac t1
        dac bxhi
box3,   lac i 12
        dac t1
        cma
        tad (1
        dac t3
        tad bylo
        spa
        jmp box4
        lac t1
        dac bylo
        jmp box1
box4,   lac t3
        tad byhi
        sma
        jmp box1
        lac t1
        dac byhi
        jmp box1

/ Append (apx, apy) to the polygon that 11 writes, unless it repeats the last.
append, 0
        lac pn
        sna
        jmp appen1
        lac apx
        sad lastx
        skp
        jmp appen1
        lac apy
        sad lasty
        jmp i append
appen1, lac pn
        sad (20
        jmp flt4
        lac apx
        dac i 11
        dac lastx
        lac apy
        dac i 11
        dac lasty
        isz pn
        jmp i append

/ Drop the last vertex if it equals the first.
wrap,   0
        lac pn
        tad (777776
        spa
        jmp i wrap
        lac 11          / the first vertex is 2*pn words back
        tad (1
        dac t1
        lac pn
        rcl
        cma
        tad (1
        tad t1
        dac t1
        lac i t1
        sad lastx
        skp
        jmp i wrap
        isz t1
        lac i t1
        sad lasty
        skp
        jmp i wrap
        lac pn
        tad (777777
        dac pn
        jmp i wrap

/ Intersect the projected opening (poly, pn) with the mask; AC = 0 if empty.
isect,  0
        lac (poly-1
        dac 12
        lac pn
        dac bn
        jms box
        lac bxhi        / no overlap of the boxes: not visible
        tad nxlo
        sma sza
        skp
        jmp isec0
        lac bxlo
        cma
        tad xhi1
        sma sza
        skp
        jmp isec0
        lac byhi
        tad nylo
        sma sza
        skp
        jmp isec0
        lac bylo
        cma
        tad yhi1
        sma sza
        skp
        jmp isec0
        lac revers
        sza
        jms turn
        lac bxlo
        tad nxlo
        sma
        jmp isec2
        lac (jms sidxl
        jms shpass
        sna
        jmp i isect
isec2,  lac bxhi
        cma
        tad xhi1
        sma
        jmp isec3
        lac (jms sidxh
        jms shpass
        sna
        jmp i isect
isec3,  lac bylo
        tad nylo
        sma
        jmp isec4
        lac (jms sidyl
        jms shpass
        sna
        jmp i isect
isec4,  lac byhi
        cma
        tad yhi1
        sma
        jmp isec5
        lac (jms sidyh
        jms shpass
        sna
        jmp i isect
isec5,  lac nslope
        sna
        jmp isec7
        dac nsl
        lac (slopes-1
        dac 13
isec6,  jms getedg
        lac (jms side2
        jms shpass
        sna
        jmp i isect
        isz nsl
        jmp isec6
isec7,  lac (poly-1
        dac 12
        lac pn
        dac bn
        jms box
        lac bxlo
        sad bxhi
        jmp isec0
        lac bylo
        sad byhi
        jmp isec0
        jms area2
        jmp i isect
isec0,  lac (0
        jmp i isect

/ Sides of the box: AC = signed distance of (spx, spy).
sidxl,  0
        lac spx
        tad nxlo
        jmp i sidxl
sidxh,  0
        lac spx
        cma
        tad xhi1
        jmp i sidxh
sidyl,  0
        lac spy
        tad nylo
        jmp i sidyl
sidyh,  0
        lac spy
        cma
        tad yhi1
        jmp i sidyh

/ One round of clipping: poly against the line whose distance the instruction
/ in AC gives.  The result is poly again; AC = its number of vertices, or 0.
shpass, 0
        dac shdis1
        dac shdis2
        lac (poly-1
        dac 12
        lac (polq-1
        dac 11
        lac pn
        cma
        tad (1
        dac shcnt
        dzm pn
        lac i 12
        dac lax
        dac shfx
        lac i 12
        dac lay
        dac shfy
        lac lax
        dac spx
        lac lay
        dac spy
shdis1, jms side2
        dac dp
shnext, isz shcnt
        jmp shget
        lac shfx        / the last side ends where the first began
        dac lbx
        lac shfy
        dac lby
        jmp shtest
shget,  lac i 12
        dac lbx
        lac i 12
        dac lby
shtest, lac lbx
        dac spx
        lac lby
        dac spy
shdis2, jms side2
        dac dq
        lac dp
        spa
        jmp shout
        lac lax         / p is inside
        dac apx
        lac lay
        dac apy
        jms append
        lac dq
        sma
        jmp shstep
        jmp shcros
shout,  lac dq
        spa
        jmp shstep
shcros, lac shdis1
        sad (jms side2
        jmp shcr1
        jms ratio1
        jmp shcr2
shcr1,  jms both2
shcr2,  jms cross
        lac crx
        dac apx
        lac cry
        dac apy
        jms append
shstep, lac lbx
        dac lax
        lac lby
        dac lay
        lac dq
        dac dp
        lac shcnt
        sza
        jmp shnext
        jms wrap
        lac pn
        tad (777775
        spa
        jmp shnone
        lac pn          / back into poly
        rcl
        cma
        tad (1
        dac cnt
        lac (polq-1
        dac 15
        lac (poly-1
        dac 16
shcopy, lac i 15
        dac i 16
        isz cnt
        jmp shcopy
        lac pn
        jmp i shpass
shnone, lac (0
        jmp i shpass

/ Reverse the order of the polygon's vertices.
turn,   0
        lac pn
        rcl
        tad (poly-2
        dac t1          / the last vertex
        lac (polq-1
        dac 16
        lac pn
        cma
        tad (1
        dac cnt
turn1,  lac i t1
        dac i 16
        isz t1
        lac i t1
        dac i 16
        lac t1
        tad (777775
        dac t1
        isz cnt
        jmp turn1
        lac (polq-1
        dac 15
        lac (poly-1
        dac 16
        lac pn
        rcl
        cma
        tad (1
        dac cnt
turn2,  lac i 15
        dac i 16
        isz cnt
        jmp turn2
        jmp i turn

/ AC = 0 if the polygon has a sloped edge and no area, otherwise not 0.
area2,  0
        lac (poly-1
        dac 12
        lac pn
        cma
        tad (1
        dac cnt
        lac i 12
        dac lax
        dac shfx
        lac i 12
        dac lay
        dac shfy
area2a, isz cnt
        skp
        jmp area2b
        lac i 12
        dac lbx
        lac i 12
        dac lby
        jms slopp
        sza
        jmp area2c
        jmp area2a
area2b, lac shfx
        dac lbx
        lac shfy
        dac lby
        jms slopp
        sza
        jmp area2c
        lac (1          / all edges lie on the box
        jmp i area2
area2c, dzm acch        / fan of triangles from the first vertex
        dzm accl
        lac (poly+1
        dac 12
        lac pn
        tad (777776
        cma
        tad (1
        dac cnt
        jms fanvtx
area2d, lac fvx
        dac fux
        lac fvy
        dac fuy
        jms fanvtx
        lac fvy
        dac smb
        lac fux
        jms addprd
        lac fuy
        dac smb
        lac fvx
        cma
        tad (1
        jms addprd
        isz cnt
        jmp area2d
        lac acch
        spa
        jmp area2e
        sza
        jmp i area2
        lac accl
        jmp i area2
area2e, lac (0
        jmp i area2

fanvtx, 0               / next vertex, less the first
        lac poly
        cma
        tad (1
        tad i 12
        dac fvx
        lac poly+1
        cma
        tad (1
        tad i 12
        dac fvy
        jmp i fanvtx

slopp,  0               / AC nonzero if A-B is sloped; B becomes A
        lac lax
        sad lbx
        jmp slopp1
        lac lay
        sad lby
        jmp slopp1
        lac (1
        jmp i slopp
slopp1, lac lbx
        dac lax
        lac lby
        dac lay
        lac (0
        jmp i slopp

/ The current mask
mn,     0               / vertices
mask=.
.+40/
nxlo,   0               / -xlo, xhi+1, -ylo, yhi+1 of its box
xhi1,   0
nylo,   0
yhi1,   0
nslope, 0               / minus the number of sloped edges
slopes=.
.+100/
/ The polygon being made
pn,     0
poly=.
.+40/
polq=.
.+40/
lastx,  0
lasty,  0
apx,    0
apy,    0
bn,     0
bxlo,   0
bxhi,   0
bylo,   0
byhi,   0
shcnt,  0
shfx,   0
shfy,   0
fux,    0
fuy,    0
fvx,    0
fvy,    0
t3,     0
t4,     0
t5,     0
