/ Tape 9: a view turned about the vertical
/
/ Only with ROTATE=1.  A corner is reached by vectors along the axes as before;
/ beside its place px py pz two double words rx and rz, in units of 2^-16, hold
/ x and z as seen in the direction of the view.  They are sums of products, so
/ nothing is rounded, and all ways to a corner give the same place.  What is seen
/ is |x| and |y| not above K times z; a line is cut where it meets that.

        IFNZRO ROTATE <

/ K, as a shift: 2, one more while K*W is below 1024 points, 0 if K*W is above
/ 2^15.  From here on pjw has K*W, and all divisors are K*z.
/ In: pjw.  Out: pjw kap zlim shk shkr vmask.  Destroys: t1.
setbnd, 0
        clc
        dac vmask
        lac (2
        dac kap
        lac (40000      / 2^(16-2)
        dac zlim
        lac pjw
        rcl
        rcl
sbnext, dac t1
        tad (-u2000+1
        sma
        jmp sbmost
        lac zlim
        rcr
        dac zlim
        isz kap
        lac t1
        rcl
        jmp sbnext
sbmost, lac t1
        tad (-100001+1
        spa
        jmp sbset
        dzm kap
        lac (200000
        dac zlim
        lac pjw
        dac t1
sbset,  lac t1
        dac pjw
        IFNZRO EAE <
        lac kap
        tad (lls
        dac shk
        lac kap
        tad (lrss
        dac shkr
        >
        jmp i setbnd

/ Follow a chain of vectors.  10 points before its X; on return at its last
/ word.  Real lines are drawn; with ringf set the corners are collected as a
/ polygon.
/ In: 10, ringf, vmask, the mask, nex ney nez cosw sinw nsinw; with ringf set
/   also a polygon begun by newpol.
/ Out: 10; the lines are in the file, the corners in the polygon.
/ Destroys: 16 px to vmag, code to fset, lax lay lbx lby and what clip2 and
/   append destroy.
chain,  0
        lac i 10
        tad nex
        dac px
        lac i 10
        tad ney
        dac py
        lac i 10
        tad nez
        dac pz
        dzm rxh
        dzm rxl
        dzm rzh
        dzm rzl
        lac px
        jms alongi
        lac pz
        jms alongk
        dzm known
        dzm lside
        dzm fside
        dzm fset
        lac i 10
        cma
        tad (1
        sna
        jmp i chain
        dac nvec
vector, lac i 10
        and vmask
        dac vecw
        and (300000
        sna
        jmp flt6
        dac vaxis
        lac ringf
        sza
        jmp vactiv
        lac vecw
        spa
        jmp vactiv
        dzm known       / a dummy
        jms vmove
        jmp vecend
vactiv, lac known
        sna
        jms corner      / the end before, if nothing has asked for it
        lac code
        dac acode
        lac cx
        dac ax
        lac cy
        dac ay
        lac cyc
        dac ayc
        jms vmove
        jms corner
        lac cx
        dac bx
        lac cy
        dac by
        lac cyc
        dac byc
        lac vaxis
        sad (200000
        skp
        jmp level
        lac code        / along j: only y changes
        sza
        jmp vecend
        lac vecw
        spa
        jms vline
vecend, isz nvec
        jmp vector
        lac ringf
        sna
        jmp i chain
        lac fside       / the outline is closed
        jms round
        jmp i chain

/ A vector along i or k.
level,  lac acode
        and code
        sza
        jmp vecend      / both ends are beyond one side
        lac vaxis
        sad (100000
        jmp levi
        lac px
        dac hw          / what does not change along it
        lac sinw
        dac halpha
        lac cosw
        jmp levset
levi,   lac pz
        dac hw
        lac cosw
        dac halpha
        lac nsinw
levset, dac hbeta
        dzm aside
        dzm bside
        lac code
        dac othc
        lac cx
        dac othx
        lac (ax-1
        dac 16
        lac acode
        sza
        jms side
        lac acode
        dac othc
        lac ax
        dac othx
        lac (bx-1
        dac 16
        lac code
        sza
        jms side
        dzm bent
        lac ayc
        sad byc
        jmp levdrw
        lac hbeta
        sza
        jms bend
levdrw, lac vecw
        spa
        jms vline
        lac ringf
        sna
        jmp vecend
        lac fset
        sza
        jmp levgon
        isz fset
        lac aside
        dac fside
        skp
levgon, lac aside
        jms round
        lac ax
        dac crx
        lac ay
        dac cry
        jms append
        lac bent
        sna
        jmp levend
        lac mx
        dac crx
        lac my
        dac cry
        jms append
levend, lac bx
        dac crx
        lac by
        dac cry
        jms append
        lac bside
        dac lside
        jmp vecend

/ Draw the line from a to b, or from or to where it bends.
/ In: ax ay ayc bx by bent mx my, the mask, the file.
/ Out: the file.  Destroys: lax lay lbx lby, what clip2 destroys.
vline,  0
        lac ax
        dac lax
        lac ay
        dac lay
        lac bx
        dac lbx
        lac by
        dac lby
        lac vaxis
        sad (200000
        jmp vldraw
        lac bent
        sna
        jmp vldraw
        lac ayc
        sza
        jmp vlbent
        lac mx
        dac lbx
        lac my
        dac lby
        jmp vldraw
vlbent, lac mx
        dac lax
        lac my
        dac lay
vldraw, jms clip2
        jmp i vline

/ Go along a vector.
/ In: vecw vaxis, the place.
/ Out: the place, px py pz rx rz.  Destroys: vmag, what along destroys.
vmove,  0
        lac vecw
        and (77777
        xor (40000
        tad (740000
        dac vmag
        lac vaxis
        sad (100000
        jmp vmovei
        sad (200000
        jmp vmovej
        lac vmag
        tad pz
        dac pz
        lac vmag
        jms alongk
        jmp i vmove
vmovei, lac vmag
        tad px
        dac px
        lac vmag
        jms alongi
        jmp i vmove
vmovej, lac vmag
        tad py
        dac py
        jmp i vmove

/ In: AC = units along k, cosw nsinw, rx rz.  Out: rx rz.
/ Destroys: smb along alongz acch accl.
alongk, 0
        dac smb
        lac nsinw
        dac alongx
        lac cosw
        jms along
        jmp i alongk
/ In: AC = units along i, cosw sinw, rx rz.  Out: rx rz.
/ Destroys: smb alongx alongz acch accl.
alongi, 0
        dac smb
        lac cosw
        dac alongx
        lac sinw
        jms along
        jmp i alongi
/ In: smb, alongx and AC = its factors for x and z.  Out: rx rz.
/ Destroys: alongz acch accl.
along,  0
        dac alongz
        lac rxh
        dac acch
        lac rxl
        dac accl
        lac alongx
        jms addprd
        lac acch
        dac rxh
        lac accl
        dac rxl
        lac rzh
        dac acch
        lac rzl
        dac accl
        lac alongz
        jms addprd
        lac acch
        dac rzh
        lac accl
        dac rzl
        jmp i along

/ The corner reached: is it between the sides of the view, and where on the
/ screen?
/ In: py rx rz zlim shk.
/ Out: code, 1 beyond the right side, 2 the left; 0: cx, cy, and cyc nonzero if
/   y is drawn back to the bound; known.
/ Destroys: dh dl t1 t3 acch accl, what quot destroys; leaves by flt3 if z is
/   too large.
corner, 0
        lac (1
        dac known
        lac rzh
        tad zlim
        spa
        jmp flt3
        cma
        tad zlim
        tad zlim
        spa
        jmp flt3
        IFNZRO EAE <
        lac rzl
        lmq
        lac rzh
        cll
shk,    lls
        dac dh
        lacq
        dac dl
        >
        IFZERO EAE <
        lac rzh
        dac dh
        lac rzl
        dac dl
        lac kap
        cma
        tad (1
        sna
        jmp coside
        dac cnt
coshft, lac dl
        rcl
        dac dl
        lac dh
        ral
        dac dh
        isz cnt
        jmp coshft
        >
coside, dzm code
        lac dl          / x - K*z - 1
        cma
        cll
        tad rxl
        glk
        dac t1
        lac dh
        cma
        tad rxh
        tad t1
        sma
        isz code
        lac dl          / x + K*z
        cll
        tad rxl
        glk
        tad dh
        tad rxh
        sma
        jmp coeye
        lac code
        tad (2
        dac code
coeye,  lac code
        sza
        jmp i corner
        lac dh
        sna
        lac dl
        sza
        jmp coseen
        lac (3          / above or below the eye
        dac code
        jmp i corner
coseen, jms setd
        lac rxl
        dac accl
        lac rxh
        dac acch
        dac t3
        jms absacc
        jms quot
        jms signed
        dac cx
        lac py
        jms sixten
        jms quot
        jms signed
        dac cy
        lac qc
        dac cyc
        jmp i corner

/ The end of a level vector that is beyond a side of the view, moved to that
/ side.
/ In: AC = its code; othc othx = code and x of the other end; hw halpha hbeta
/   py, 16.
/ Out: the four words behind 16: x, y, drawn back, side 1, 2, or 4 at the eye.
/ Destroys: sig sbeta dh dl t1 t3 t4 smb acch accl, what quot destroys; goes to
/   vecend if the vector passes behind the eye.
side,   0
        dac t4
        lac hw
        sna
        jmp sdeye
        lac t4
        sad (1
        jmp sdrigh
        sad (2
        jmp sdleft
        lac hw          / from behind the eye
        xor hbeta
        spa
        jmp sdleft
sdrigh, lac (0
        skp
sdleft, clc
        dac sig
        dac t3
        lac hbeta
        jms signed
        dac sbeta
        lac halpha      / is the line before the eye on this side?
        dac acch
        dzm accl
        jms shrk
        lac acch
        tad sbeta
        xor hw
        spa
        jmp vecend
        lac pjw
        jms signed
        dac i 16
        lac hw
        jms sixten
        lac acch
        dac dh
        lac accl
        dac dl
        jms setd
        jms absy
        lac halpha
        jms addprd
        jms shrk
        lac sbeta
        jms addprd
        jms absacc
        lac py
        dac t3
        jms quot
        jms signed
        dac i 16
        lac qc
        dac i 16
        lac sig
        cma
        tad (2
        dac i 16
        jmp i side
sdeye,  lac othc        / it goes through the eye's vertical
        sza
        jmp vecend
        lac py
        sna
        jmp vecend
        dac t3
        lac othx
        dac i 16
        lac pjw
        jms signed
        dac i 16
        lac (1
        dac i 16
        lac (4
        dac i 16
        jmp i side

/ Where a level vector meets the upper or lower side of the bound.
/ In: hw halpha hbeta py pjw.
/ Out: bent, mx, my.
/ Destroys: dh dl t1 t3 smb acch accl, what quot destroys.
bend,   0
        isz bent
        jms absy
        lac hbeta
        jms addprd
        jms absacc
        lac acch
        dac dh
        lac accl
        dac dl
        jms setd
        jms absy
        lac halpha
        jms addprd
        jms shrk
        jms negacc
        lac hw
        dac smb
        lac (200000
        jms addprd
        lac acch
        xor hbeta
        dac t3
        jms absacc
        jms quot
        jms signed
        dac mx
        lac py
        dac t3
        lac pjw
        jms signed
        dac my
        jmp i bend

/ In: py.  Out: smb = |py|, acch accl zero.  Destroys: nothing else.
absy,   0
        dzm acch
        dzm accl
        lac py
        sma
        jmp .+3
        cma
        tad (1
        dac smb
        jmp i absy

/ Where the outline left the view by one side and comes back by another it has
/ gone round the eye: append the corners of the bound between them.
/ In: AC = the side where it comes back, lside, py pjw, the polygon.
/ Out: the polygon.
/ Destroys: crx cry t1 t3 t5.
round,  0
        sna
        jmp i round
        dac t5
        lac lside
        sna
        jmp i round
        sad t5
        jmp i round
        jms rndcor
        lac t5
        jms rndcor
        jmp i round
/ In: AC = a side, py pjw.  Out: the polygon.  Destroys: crx cry t1 t3.
rndcor, 0
        sad (4
        jmp i rndcor
        tad (777776
        cma
        dac t3
        lac pjw
        jms signed
        dac crx
        lac py
        dac t3
        lac pjw
        jms signed
        dac cry
        jms append
        jmp i rndcor

/ AC, negated if t3 is negative.
/ In: AC, t3.  Out: AC.  Destroys: t1.
signed, 0
        dac t1
        lac t3
        spa
        jmp sgneg
        lac t1
        jmp i signed
sgneg,  lac t1
        cma
        tad (1
        jmp i signed

/ acch,accl = |AC| * 2^16, t3 = AC.
/ In: AC.  Out: acch accl t3.  Destroys: nothing else.
sixten, 0
        dac t3
        sma
        jmp .+3
        cma
        tad (1
        rcr
        dac acch
        lac (0
        rar
        dac accl
        lac acch
        rcr
        dac acch
        lac accl
        rar
        dac accl
        jmp i sixten

/ dh,dl becomes the divisor: its first 17 bits, and how far to shift to them.
/ In: dh dl, positive and below 2^34.
/ Out: the divisor of proj, qsh.
/ Destroys: without the EAE mds mdr.
setd,   0
        IFNZRO EAE <
        lac dl
        lmq
        lac dh
        cll
        norm
        jms setz
        lacs
        tad (640544     / lls, less what lacs has for no shift
        dac qsh
        >
        IFZERO EAE <
        lac dh
        dac mdr
        lac dl
        dac mds
        dzm qsh
sdshft, lac qsh
        tad (777777
        dac qsh
        lac mds
        rcl
        dac mds
        lac mdr
        ral
        dac mdr
        and (200000
        sna
        jmp sdshft
        lac mdr
        jms setz
        >
        jmp i setd

/ AC = acch,accl * K*W / dh,dl, not above K*W: then qc is nonzero.
/ In: acch accl, not negative; dh dl by setd.
/ Out: AC, qc.
/ Destroys: t1 acch accl, without the EAE cnt, what proj destroys.
quot,   0
        dzm qc
        lac dl
        cma
        cll
        tad accl
        glk
        dac t1
        lac dh
        cma
        tad acch
        tad t1
        sma
        jmp quotkw
        IFNZRO EAE <
        lac accl
        lmq
        lac acch
        cll
qsh,    lls
        >
        IFZERO EAE <
        lac qsh
        dac cnt
qushft, lac accl
        rcl
        dac accl
        lac acch
        ral
        dac acch
        isz cnt
        jmp qushft
        >
        jms proj
        jmp i quot
quotkw, isz qc
        lac pjw
        jmp i quot

/ acch,accl = acch,accl / K, rounded down.
/ In: acch accl kap.  Out: acch accl.  Destroys: without the EAE cnt.
shrk,   0
        IFNZRO EAE <
        lac accl
        lmq
        lac acch
shkr,   lrss
        dac acch
        lacq
        dac accl
        >
        IFZERO EAE <
        lac kap
        cma
        tad (1
        sna
        jmp i shrk
        dac cnt
srshft, lac acch
        cll
        spa
        stl
        rar
        dac acch
        lac accl
        rar
        dac accl
        isz cnt
        jmp srshft
        >
        jmp i shrk

/ The outline of an opening becomes the polygon; its lines are drawn.
/ In: org, what chain needs.  Out: the polygon, pn.
/ Destroys: what chain destroys.
outlin, 0
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
        jmp i outlin

/ A view begins: turn, and turn the steps in x and z to where the view looks.
/ In: angle, step to step+3, remx remz.
/ Out: angle, 0 to 359; cosw sinw nsinw; step step+2 remx remz.
/ Destroys: t1 t3 t4 smb acch accl.
newdir, 0
        lac angle
        jms degree
        dac angle
        lac step+3
        jms degree
        tad angle
        jms degree
        dac angle
        jms sine
        dac sinw
        cma
        tad (1
        dac nsinw
        lac angle
        tad (132
        jms sine
        dac cosw
        lac remx
        dac accl
        dzm acch
        lac step
        dac smb
        lac cosw
        jms addprd
        lac step+2
        dac smb
        lac sinw
        jms addprd
        jms whole
        dac t4
        lac t1
        dac remx
        lac remz
        dac accl
        dzm acch
        lac step
        dac smb
        lac nsinw
        jms addprd
        lac step+2
        dac smb
        lac cosw
        jms addprd
        jms whole
        dac step+2
        lac t1
        dac remz
        lac t4
        dac step
        jmp i newdir

/ In: acch accl.  Out: AC = acch,accl / 2^16, rounded down; t1 = the remainder.
/ Destroys: acch accl.
whole,  0
        lac accl
        and (177777
        dac t1
        lac accl
        rcl
        dac accl
        lac acch
        ral
        dac acch
        lac accl
        rcl
        lac acch
        ral
        jmp i whole

/ In: AC.  Out: AC = the same direction, 0 to 359 degrees.  Destroys: nothing else.
degree, 0
        spa
        jmp dgmore
dgless, tad (-550+1
        sma
        jmp dgless
        tad (550
        jmp i degree
dgmore, tad (550
        spa
        jmp dgmore
        jmp i degree

/ In: AC = degrees.  Out: AC = the sine times 2^16.  Destroys: t1 t3.
sine,   0
        jms degree
        tad (-264+1
        dac t3          / not negative: the second half
        spa
        tad (264
        dac t1
        tad (-132+1
        spa
        jmp sitabl
        lac t1          / 180 - AC
        cma
        tad (265
        dac t1
sitabl, lac t3
        cma
        dac t3
        lac t1
        tad (sines
        dac t1
        lac i t1
        jms signed
        jmp i sine

/ The eyes of a stereo pair are side by side as the view looks.
/ In: AC = units to the right, ex ez cosw nsinw, scene tape.
/ Out: pex pez.
/ Destroys: limlo limhi limt smb acch accl t1.
beside, 0
        dac smb
        dzm acch
        lac (100000
        dac accl
        lac cosw
        jms addprd
        jms whole
        tad ex
        jms limitx
        dac pex
        dzm acch
        lac (100000
        dac accl
        lac nsinw
        jms addprd
        jms whole
        tad ez
        dac limt
        lac scene+11
        dac limlo
        lac scene+12
        dac limhi
        lac limt
        jms limit
        dac pez
        jmp i beside

sines,  0               / of 0 to 90 degrees, times 2^16
        2170
        4357
        6546
        10734
        13120
        15302
        17463
        21641
        24014
        26164
        30331
        32472
        34626
        36757
        41102
        43220
        45331
        47434
        51530
        53617
        55676
        57746
        62007
        64040
        66061
        70071
        72071
        74057
        76034
        100000
        101732
        103651
        105555
        107447
        111326
        113171
        115021
        116634
        120433
        122216
        123763
        125514
        127227
        130725
        132405
        134047
        135472
        137077
        140465
        142033
        143363
        144673
        146163
        147434
        150664
        152074
        153263
        154432
        155557
        156664
        157747
        161011
        162031
        163027
        164004
        164736
        165646
        166534
        167377
        170220
        171016
        171570
        172320
        173025
        173507
        174145
        174560
        175150
        175514
        176034
        176331
        176602
        177030
        177231
        177407
        177540
        177646
        177730
        177766
        200000
angle,  0               / direction of the view, degrees to the right of +z
cosw,   0               / its cosine and sine times 2^16
sinw,   0
nsinw,  0
remx,   0               / rest of the steps, in 2^-16
remz,   0
kap,    0               / K = 2^kap
zlim,   0               / |z| is below this, in units of 4
vmask,  0               / 377777: draw no line
rxh,    0               / the point reached, as the view looks
rxl,    0
rzh,    0
rzl,    0
alongx, 0
alongz, 0
vaxis,  0
vmag,   0
known,  0               / nonzero: code, cx, cy are those of the point reached
code,   0
cx,     0
cy,     0
cyc,    0
acode,  0
ax,     0               / a vector on the screen, from a to b
ay,     0
ayc,    0
aside,  0
bx,     0
by,     0
byc,    0
bside,  0
bent,   0               / nonzero: it meets the bound at mx, my
mx,     0
my,     0
hw,     0               / a level vector: x or z of its line
halpha, 0
hbeta,  0
othc,   0
othx,   0
sig,    0
sbeta,  0
lside,  0               / by which side the outline left last
fside,  0               / and came first
fset,   0
dh,     0               / divisor
dl,     0
qc,     0
        IFZERO EAE <
qsh,    0               / minus the shifts
        >
        >
