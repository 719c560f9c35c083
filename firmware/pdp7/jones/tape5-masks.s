/ Tape 5: masks

/ A mask is kept as its box and its sloped edges: that is all that clipping
/ against it needs, and all that goes on the stack.

/ The first mask of a pass: the window.
winmsk, 0
        lac wxlo
        dac bxlo
        lac wxhi
        dac bxhi
        lac (-u1000+1
        dac bylo
        lac (u1000-unit
        dac byhi
        jms setbox
        dzm nslope
        jmp i winmsk

setbox, 0
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
        jmp i setbox

/ The polygon, with its box, becomes the current mask.
newmsk, 0
        jms setbox
        dzm nslope
        lac (slopes-1
        dac 15
        lac pcur
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
newms1, isz cnt
        skp
        jmp newms2
        lac i 12
        dac lbx
        lac i 12
        dac lby
        jms slope
        jmp newms1
newms2, lac shfx        / the last vertex to the first
        dac lbx
        lac shfy
        dac lby
        jms slope
        jmp i newmsk

/ Add the edge (lax,lay)-(lbx,lby) if it is sloped; b becomes a.
slope,  0
        lac lax
        sad lbx
        jmp slope1
        lac lay
        sad lby
        jmp slope2
        lac lax
        cma
        tad (1
        dac i 15        / -a
        dac t1
        lac lay
        cma
        tad (1
        dac i 15
        dac t3
        lac t1
        tad lbx
        dac i 15        / b-a
        lac t3
        tad lby
        dac i 15
        lac nslope
        tad (777777
        dac nslope
slope1, lac lby
        dac lay
slope2, lac lbx
        dac lax
        jmp i slope

/ Box bxlo bxhi bylo byhi of the polygon.
box,    0
        lac pcur
        dac 12
        lac pn
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
        cma             / an equal one may replace the bound
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

/ Begin a polygon: room for 16 vertices, no last one.
newpol, 0
        lac (777757     / -17
        dac pnroom
        lac (400000
        dac lastx
        jmp i newpol

/ Append (crx, cry) to the polygon that 11 writes, unless it repeats the last.
append, 0
        lac crx
        sad lastx
        jmp appen2
appen1, dac i 11
        dac lastx
        lac cry
        dac i 11
        dac lasty
        isz pnroom
        jmp i append
        jmp flt4
appen2, lac cry
        sad lasty
        jmp i append
        lac crx
        jmp appen1

/ The polygon written behind the word AC is complete: count it, and drop the
/ last vertex if it equals the first.
wrap,   0
        tad (1
        dac t1
        lac pnroom
        tad (21
        dac pn
        tad (777776
        spa
        jmp i wrap
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

/ Intersect the projected opening, whose box is within bxlo bxhi bylo byhi, with
/ the mask; AC = 0 if nothing is left but a point or a line along an axis.  With
/ rectf set there is the box alone, and it becomes that of the intersection.
isect,  0
        lac revers
        sza
        jms turn
        lac bxlo
        tad nxlo
        sma
        jmp isec2
        jms shside
        lac lbx
        nop
        tad nxlo
        lac nxlo        / what is left lies within the line
        cma
        tad (1
        dac bxlo
isec2,  lac bxhi
        cma
        tad xhi1
        sma
        jmp isec3
        jms shside
        lac lbx
        cma
        tad xhi1
        lac xhi1
        tad (777777
        dac bxhi
isec3,  lac bylo
        tad nylo
        sma
        jmp isec4
        jms shside
        lac lby
        nop
        tad nylo
        lac nylo
        cma
        tad (1
        dac bylo
isec4,  lac byhi
        cma
        tad yhi1
        sma
        jmp isec5
        jms shside
        lac lby
        cma
        tad yhi1
        lac yhi1
        tad (777777
        dac byhi
isec5,  lac nslope
        sna
        jmp isec7
        dac nsl
        lac (slopes-1
        dac 13
isec6,  jms getedg
        lac edy         / the corner of the box that is farthest out
        sma
        jmp isec8
        lac bxlo
        skp
isec8,  lac bxhi
        dac spx
        lac edx
        sma
        jmp isec9
        lac byhi
        skp
isec9,  lac bylo
        dac spy
        jms side2
        sma
        jmp isec10      / all inside: nothing to cut
        IFNZRO EAE <
        lac rectf
        sza
        jmp crosbr
        >
        lac (jms shslop
        dac shd1
        lac (nop
        dac shd2
        jms shpass
        sna
        jmp i isect
isec10, isz nsl
        jmp isec6
isec7,  lac rectf
        sna
        jms box
        lac bxlo
        sad bxhi
        jmp isec0
        lac bylo
        sad byhi
        jmp isec0
        lac pn
        jmp i isect
isec0,  lac (0
        jmp i isect

/ A round of clipping against a side of the box: the three instructions follow.
shside, 0
        lac rectf
        sza
        jmp shsid1
        lac i shside
        dac shd1
        isz shside
        lac i shside
        dac shd2
        isz shside
        lac i shside
        isz shside
        jms shpass
        sna
        jmp isec0
        jmp i shside
shsid1, lac shside      / a box only: the caller cuts it
        tad (3
        dac shside
        jmp i shside

/ One round of clipping against the line whose distance of (lbx, lby) the
/ three instructions at shd1 give; the third comes in AC.  p is (lax, lay) at
/ distance dp, q the vertex after it.  AC on return = the number of vertices,
/ or 0.
shd1,   lac lbx
shd2,   cma
shd3,   tad xhi1

shpass, 0
        dac shd3
        lac pcur
        dac 12
        lac palt
        dac 11
        lac pn
        cma
        tad (1
        dac shcnt
        jms newpol
        lac i 12
        dac lbx
        dac lax
        dac shfx
        lac i 12
        dac lby
        dac lay
        dac shfy
        xct shd1
        xct shd2
        xct shd3
        dac dp
        dac shfd
        spa
        jmp shout

/ p is inside: it stays.  It cannot repeat the vertex before.
shin,   lac lax
        dac i 11
        lac lay
        dac i 11
        isz pnroom
        skp
        jmp flt4
shin1,  isz shcnt
        jmp shin2
        lac lax
        dac lastx
        lac lay
        dac lasty
        jms shlast      / from the last vertex to the first
        spa
        jms shcros
        jmp shdone
shin2,  lac i 12
        dac lbx
        lac i 12
        dac lby
        xct shd1
        xct shd2
        xct shd3
        spa
        jmp shin3
        dac dp
        lac lbx
        dac lax
        lac lby
        dac lay
        jmp shin
shin3,  dac dq          / it leaves
        lac lax
        dac lastx
        lac lay
        dac lasty
        jms shcros

shout,  isz shcnt
        jmp shout1
        jms shlast
        sma
        jms shcros
        jmp shdone
shout1, lac i 12
        dac lbx
        lac i 12
        dac lby
        xct shd1
        xct shd2
        xct shd3
        sma
        jmp shout2
        dac dp
        lac lbx
        dac lax
        lac lby
        dac lay
        jmp shout
shout2, dac dq          / it enters; the first vertex may be the crossing
        jms shcros
        lac lax
        dac crx
        lac lay
        dac cry
        jms append
        jmp shin1

shdone, lac palt
        jms wrap
        jms swap        / the result is the current polygon
        lac pn
        tad (777775
        spa
        jmp shnone
        lac pn
        jmp i shpass
shnone, lac (0
        jmp i shpass

shlast, 0               / q = the first vertex: AC its distance
        lac shfx
        dac lbx
        lac shfy
        dac lby
        lac shfd
        dac dq
        jmp i shlast

shcros, 0               / append the crossing of p-q; q becomes p
        lac shd1
        sad (jms shslop
        jmp shcr1
        jms ratio1
        skp
shcr1,  jms both2
        jms cross
        jms append
        lac lbx
        dac lax
        lac lby
        dac lay
        lac dq
        dac dp
        jmp i shcros

shslop, 0               / the side of the sloped edge
        lac lbx
        dac spx
        lac lby
        dac spy
        jms side2
        isz shslop      / past shd2 and shd3
        isz shslop
        jmp i shslop

/ Reverse the order of the polygon's vertices.
turn,   0
        lac pn
        rcl
        tad pcur
        tad (777777
        dac t1          / the last vertex
        lac palt
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
        jms swap
        jmp i turn

swap,   0
        lac pcur
        dac t1
        lac palt
        dac pcur
        lac t1
        dac palt
        jmp i swap

/ AC = 0 if the polygon has no area.
area2,  0
        dzm acch        / fan of triangles from the first vertex
        dzm accl
        lac pcur
        dac 12
        lac i 12
        cma
        tad (1
        dac nfx
        lac i 12
        cma
        tad (1
        dac nfy
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
        lac i 12
        tad nfx
        dac fvx
        lac i 12
        tad nfy
        dac fvy
        jmp i fanvtx

/ The current mask, as it goes on the stack
maskw=.
nslope, 0               / minus the number of sloped edges
nxlo,   0               / -xlo, xhi+1, -ylo, yhi+1 of its box
xhi1,   0
nylo,   0
yhi1,   0
slopes=.                / -a.x, -a.y, and the vector to b, of each
.+100/
/ The polygon being made
pn,     0
pcur,   0               / word before its first vertex
palt,   0               / the other buffer
poly=.
.+42/
polq=.
.+42/
pnroom, 0               / vertices so far, less 17
lastx,  0
lasty,  0
bxlo,   0
bxhi,   0
bylo,   0
byhi,   0
shcnt,  0
shfd,   0
shfx,   0
shfy,   0
nfx,    0
nfy,    0
fux,    0
fuy,    0
fvx,    0
fvy,    0
t3,     0
t4,     0
t5,     0
