/ Tape 5: masks

/ A mask is kept as its box and its sloped edges: that is all that clipping
/ against it needs, and all that goes on the stack.

/ The first mask of a pass: the window.
/ In: wxlo wxhi.  Out: the mask.  Destroys: bxlo bxhi bylo byhi.
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

/ In: bxlo bxhi bylo byhi.  Out: nxlo xhi1 nylo yhi1.  Destroys: nothing else.
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
/ In: the polygon, bxlo bxhi bylo byhi.
/ Out: the mask.
/ Destroys: 12 15 cnt lax lay lbx lby shfx shfy t1 t3.
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
nmedge, isz cnt
        skp
        jmp nmlast
        lac i 12
        dac lbx
        lac i 12
        dac lby
        jms slope
        jmp nmedge
nmlast, lac shfx        / the last vertex to the first
        dac lbx
        lac shfy
        dac lby
        jms slope
        jmp i newmsk

/ Add the edge (lax,lay)-(lbx,lby) if it is sloped; b becomes a.
/ In: lax lay lbx lby, 15 where it is written, nslope.
/ Out: 15, nslope, lax lay.
/ Destroys: t1 t3.
slope,  0
        lac lax
        sad lbx
        jmp slmovy
        lac lay
        sad lby
        jmp slmovx
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
slmovy, lac lby
        dac lay
slmovx, lac lbx
        dac lax
        jmp i slope

/ Box bxlo bxhi bylo byhi of the polygon.
/ In: the polygon.  Out: bxlo bxhi bylo byhi.  Destroys: 12 cnt t1 t3.
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
bxnext, isz cnt
        skp
        jmp i box
        lac i 12
        dac t1
        cma             / an equal one may replace the bound
        dac t3
        tad bxlo
        spa
        jmp bxxhi
        lac t1
        dac bxlo
        jmp bxy
bxxhi,  lac t3
        tad bxhi
        sma
        jmp bxy
        lac t1
        dac bxhi
bxy,    lac i 12
        dac t1
        cma
        dac t3
        tad bylo
        spa
        jmp bxyhi
        lac t1
        dac bylo
        jmp bxnext
bxyhi,  lac t3
        tad byhi
        sma
        jmp bxnext
        lac t1
        dac byhi
        jmp bxnext

/ Begin a polygon: room for 16 vertices, no last one.
/ Out: pnroom, lastx of the polygon being made.  Destroys: nothing else.
newpol, 0
        lac (777757     / -17
        dac pnroom
        lac (400000
        dac lastx
        jmp i newpol

/ Append (crx, cry) to the polygon that 11 writes, unless it repeats the last.
/ In: crx cry, the polygon being made.
/ Out: the polygon.
/ Destroys: nothing else; leaves by flt4 if the polygon is full.
append, 0
        lac crx
        sad lastx
        jmp apsamx
apput,  dac i 11
        dac lastx
        lac cry
        dac i 11
        dac lasty
        isz pnroom
        jmp i append
        jmp flt4
apsamx, lac cry
        sad lasty
        jmp i append
        lac crx
        jmp apput

/ The polygon written behind the word AC is complete: count it, and drop the
/ last vertex if it equals the first.
/ In: AC, the polygon being made.  Out: pn.  Destroys: t1.
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
/ In: the polygon, bxlo bxhi bylo byhi, revers, rectf, the mask.
/ Out: AC, the polygon, bxlo bxhi bylo byhi.
/ Destroys: 13 neax neay edx edy nedy nsl sdload sdneg, what turn, box and
/   shpass destroy; leaves by crosbr if rectf is set and a sloped edge cuts the
/   box.
isect,  0
        lac revers
        sza
        jms turn
        lac bxlo
        tad nxlo
        sma
        jmp isxhi
        jms shside
        lac lbx
        nop
        tad nxlo
        lac nxlo        / what is left lies within the line
        cma
        tad (1
        dac bxlo
isxhi,  lac bxhi
        cma
        tad xhi1
        sma
        jmp isylo
        jms shside
        lac lbx
        cma
        tad xhi1
        lac xhi1
        tad (777777
        dac bxhi
isylo,  lac bylo
        tad nylo
        sma
        jmp isyhi
        jms shside
        lac lby
        nop
        tad nylo
        lac nylo
        cma
        tad (1
        dac bylo
isyhi,  lac byhi
        cma
        tad yhi1
        sma
        jmp isslop
        jms shside
        lac lby
        cma
        tad yhi1
        lac yhi1
        tad (777777
        dac byhi
isslop, lac nslope
        sna
        jmp isbox
        dac nsl
        lac (slopes-1
        dac 13
isedge, jms getedg
        lac edy         / the corner of the box that is farthest out
        sma
        jmp isxmax
        lac bxlo
        skp
isxmax, lac bxhi
        dac spx
        lac edx
        sma
        jmp isymin
        lac byhi
        skp
isymin, lac bylo
        dac spy
        jms side2
        sma
        jmp isnext      / all inside: nothing to cut
        IFZERO ROTATE <
        IFNZRO EAE <
        lac rectf
        sza
        jmp crosbr
        >
        >
        lac (jms shslop
        dac sdload
        lac (nop
        dac sdneg
        jms shpass
        sna
        jmp i isect
isnext, isz nsl
        jmp isedge
isbox,  lac rectf
        sna
        jms box
        lac bxlo
        sad bxhi
        jmp isnone
        lac bylo
        sad byhi
        jmp isnone
        lac pn
        jmp i isect
isnone, lac (0
        jmp i isect

/ A round of clipping against a side of the box: the three instructions follow.
/ In: three instructions, the polygon.
/ Out: the polygon; leaves isect by isnone if it is empty.
/ Destroys: sdload sdneg, what shpass destroys.
shside, 0
        lac rectf
        sza
        jmp shsbox
        lac i shside
        dac sdload
        isz shside
        lac i shside
        dac sdneg
        isz shside
        lac i shside
        isz shside
        jms shpass
        sna
        jmp isnone
        jmp i shside
shsbox, lac shside      / a box only: the caller cuts it
        tad (3
        dac shside
        jmp i shside

/ One round of clipping against the line whose distance of (lbx, lby) the
/ three instructions at sdload give; the third comes in AC.  p is (lax, lay) at
/ distance dp, q the vertex after it.  AC on return = the number of vertices,
/ or 0.
sdload, lac lbx
sdneg,  cma
sdadd,  tad xhi1

/ In: AC, sdload, sdneg, the polygon.
/ Out: AC, the polygon.
/ Destroys: 11 12 crx cry dp dq lax lay lbx lby shfx shfy shfd mdm mdd t1; for a
/   sloped edge also spx spy acch accl smb.
shpass, 0
        dac sdadd
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
        xct sdload
        xct sdneg
        xct sdadd
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
shinq,  isz shcnt
        jmp shinxt
        lac lax
        dac lastx
        lac lay
        dac lasty
        jms shlast      / from the last vertex to the first
        spa
        jms shcros
        jmp shdone
shinxt, lac i 12
        dac lbx
        lac i 12
        dac lby
        xct sdload
        xct sdneg
        xct sdadd
        spa
        jmp shleav
        dac dp
        lac lbx
        dac lax
        lac lby
        dac lay
        jmp shin
shleav, dac dq          / it leaves
        lac lax
        dac lastx
        lac lay
        dac lasty
        jms shcros

shout,  isz shcnt
        jmp shonxt
        jms shlast
        sma
        jms shcros
        jmp shdone
shonxt, lac i 12
        dac lbx
        lac i 12
        dac lby
        xct sdload
        xct sdneg
        xct sdadd
        sma
        jmp shentr
        dac dp
        lac lbx
        dac lax
        lac lby
        dac lay
        jmp shout
shentr, dac dq          / it enters; the first vertex may be the crossing
        jms shcros
        lac lax
        dac crx
        lac lay
        dac cry
        jms append
        jmp shinq

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

/ In: shfx shfy shfd.  Out: AC = dq, lbx lby.  Destroys: nothing else.
shlast, 0               / q = the first vertex: AC its distance
        lac shfx
        dac lbx
        lac shfy
        dac lby
        lac shfd
        dac dq
        jmp i shlast

/ In: lax lay lbx lby, dp and dq for a side of the box.
/ Out: lax lay = lbx lby, dp = dq, the polygon being made.
/ Destroys: crx cry mdm mdd; for a sloped edge also spx spy acch accl smb.
shcros, 0               / append the crossing of p-q; q becomes p
        lac sdload
        sad (jms shslop
        jmp shcslp
        jms ratio1
        skp
shcslp, jms both2
        jms cross
        jms append
        lac lbx
        dac lax
        lac lby
        dac lay
        lac dq
        dac dp
        jmp i shcros

/ In: lbx lby, the edge by getedg.
/ Out: AC; returns after sdneg and sdadd.
/ Destroys: spx spy acch accl smb.
shslop, 0               / the side of the sloped edge
        lac lbx
        dac spx
        lac lby
        dac spy
        jms side2
        isz shslop      / past sdneg and sdadd
        isz shslop
        jmp i shslop

/ Reverse the order of the polygon's vertices.
/ In: the polygon.  Out: the polygon, reversed.  Destroys: 16 cnt t1.
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
trnext, lac i t1
        dac i 16
        isz t1
        lac i t1
        dac i 16
        lac t1
        tad (777775
        dac t1
        isz cnt
        jmp trnext
        jms swap
        jmp i turn

/ In: pcur, palt.  Out: pcur, palt.  Destroys: t1.
swap,   0
        lac pcur
        dac t1
        lac palt
        dac pcur
        lac t1
        dac palt
        jmp i swap

/ AC = 0 if the polygon has no area.
/ In: the polygon.  Out: AC.  Destroys: 12 cnt acch accl smb nfx nfy fvx fvy.
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
arnext, lac fvx
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
        jmp arnext
        lac acch
        spa
        jmp arneg
        sza
        jmp i area2
        lac accl
        jmp i area2
arneg,  lac (0
        jmp i area2

/ In: 12, nfx nfy.  Out: 12, fvx fvy.  Destroys: nothing else.
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
