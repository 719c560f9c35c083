/ Tape 4: clipping a line against the mask

/ The line A-B (lax lay lbx lby) against the box of the mask, then against its
/ sloped edges; what is left is drawn.  A coordinate on the line counts as
/ inside.  dp and dq are the distances of A and B from the side.
/ In: lax lay lbx lby, the mask, the file.
/ Out: the file has what is left.
/ Destroys: lax lay lbx lby 13 dp nsl spx spy, and what getedg, side2, both2,
/   cross and piece destroy.
clip2,  0
        lac lax         / x >= xlo
        tad nxlo
        dac dp
        spa
        jmp clxla
        lac lbx
        tad nxlo
        sma
        jmp clxh
        jms crosb
        jmp clxh
clxla,  lac lbx
        tad nxlo
        spa
        jmp i clip2
        jms crosa

clxh,   lac lax         / x <= xhi
        cma
        tad xhi1
        dac dp
        spa
        jmp clxha
        lac lbx
        cma
        tad xhi1
        sma
        jmp clyl
        jms crosb
        jmp clyl
clxha,  lac lbx
        cma
        tad xhi1
        spa
        jmp i clip2
        jms crosa

clyl,   lac lay         / y >= ylo
        tad nylo
        dac dp
        spa
        jmp clyla
        lac lby
        tad nylo
        sma
        jmp clyh
        jms crosb
        jmp clyh
clyla,  lac lby
        tad nylo
        spa
        jmp i clip2
        jms crosa

clyh,   lac lay         / y <= yhi
        cma
        tad yhi1
        dac dp
        spa
        jmp clyha
        lac lby
        cma
        tad yhi1
        sma
        jmp clslop
        jms crosb
        jmp clslop
clyha,  lac lby
        cma
        tad yhi1
        spa
        jmp i clip2
        jms crosa

clslop, lac nslope      / minus the number of sloped edges
        sna
        jmp cldone
        dac nsl
        lac (slopes-1
        dac 13
cledge, jms getedg
        lac lax
        dac spx
        lac lay
        dac spy
        jms side2
        dac sida
        lac lbx
        dac spx
        lac lby
        dac spy
        jms side2
        spa
        jmp clbout      / B outside
        lac sida
        sma
        jmp clnext      / both inside
        jms both2
        jms crosta
clnext, isz nsl
        jmp cledge
        jmp cldone
clbout, lac sida
        spa
        jmp i clip2     / both outside
        jms both2
        jms crostb
        jmp clnext

cldone, lac lax
        sad lbx
        skp
        jmp clpiec
        lac lay
        sad lby
        jmp i clip2     / nothing left
clpiec, jms piece
        jmp i clip2

/ A or B becomes the crossing with a side of the box; AC = the distance of B.
/ In: AC = distance of B, dp = that of A.
/ Out: lax lay.
/ Destroys: mdm mdd crx cry.
crosa,  0
        dac mdd
        lac dp          / A is outside
        cma
        tad (1
        dac mdm
        tad mdd
        dac mdd
        jms crosta
        jmp i crosa
/ In: AC = distance of B, dp = that of A.
/ Out: lbx lby.
/ Destroys: mdm mdd crx cry.
crosb,  0
        cma             / B is outside
        tad (1
        tad dp
        dac mdd
        lac dp
        dac mdm
        jms crostb
        jmp i crosb

/ A or B becomes the point at the ratio in mdm, mdd.
/ In: lax lay lbx lby mdm mdd.  Out: lax lay.  Destroys: crx cry.
crosta, 0
        jms cross
        lac crx
        dac lax
        lac cry
        dac lay
        jmp i crosta
/ In: lax lay lbx lby mdm mdd.  Out: lbx lby.  Destroys: crx cry.
crostb, 0
        jms cross
        lac crx
        dac lbx
        lac cry
        dac lby
        jmp i crostb

/ The point of A-B at mdm/mdd of the way: crx, cry.
/ In: lax lay lbx lby mdm mdd.  Out: crx cry.  Destroys: nothing else.
cross,  0
        lac lax
        cma
        tad (1
        tad lbx
        jms part
        tad lax
        dac crx
        lac lay
        cma
        tad (1
        tad lby
        jms part
        tad lay
        dac cry
        jmp i cross

/ In: AC, mdm, mdd.  Out: AC.  Destroys: nothing else.
part,   0               / AC = sign * muldiv |AC|
        sna
        jmp i part
        spa
        jmp partn
        sad mdd         / across a side of the box
        jmp partbx
        jms muldiv
        jmp i part
partn,  cma
        tad (1
        jms muldiv
        cma
        tad (1
        jmp i part
partbx, lac mdm
        jmp i part

/ Ratio |dp| / (|dp|+|dq|) of two single distances of unlike sign.
/ In: dp, dq.  Out: mdm, mdd.  Destroys: nothing else.
ratio1, 0
        lac dp
        sma
        jmp .+3
        cma
        tad (1
        dac mdm
        lac dq
        sma
        jmp .+3
        cma
        tad (1
        tad mdm
        dac mdd
        jmp i ratio1

/ The same of the double distances of A and B from the current edge.
/ In: lax lay lbx lby, the edge by getedg.
/ Out: mdm, mdd.
/ Destroys: spx spy acch accl smb.
both2,  0
        lac lax
        dac spx
        lac lay
        dac spy
        jms dist2
        jms absacc
        lac acch
        dac numh
        lac accl
        dac numl
        lac lbx
        dac spx
        lac lby
        dac spy
        jms dist2
        jms absacc
        lac numl        / den = num + |d(B)|
        cll
        tad accl
        dac denl
        glk
        tad numh
        tad acch
        dac denh
b2test, lac denh        / shift both right until den is below 2^17
        sza
        jmp b2shft
        lac denl
        spa
        jmp b2shft
        dac mdd
        lac numl
        dac mdm
        jmp i both2
b2shft, lac denh
        rcr
        dac denh
        lac denl
        rar
        dac denl
        lac numh
        rcr
        dac numh
        lac numl
        rar
        dac numl
        jmp b2test

/ In: acch accl.  Out: acch accl.  Destroys: nothing else.
absacc, 0
        lac acch
        sma
        jmp i absacc
        jms negacc
        jmp i absacc

/ In: acch accl.  Out: acch accl.  Destroys: nothing else.
negacc, 0               / the double accumulator becomes its negative
        lac accl
        cma
        cll
        tad (1
        dac accl
        lac acch
        cma
        szl
        tad (1
        dac acch
        jmp i negacc

/ Next sloped edge: a and its vector.
/ In: 13 before the edge.
/ Out: neax neay edx edy nedy; 13 before the next edge.
/ Destroys: nothing else.
getedg, 0
        lac i 13
        dac neax
        lac i 13
        dac neay
        lac i 13
        dac edx
        lac i 13
        dac edy
        cma
        tad (1
        dac nedy
        jmp i getedg

/ On which side of the edge is (spx, spy)?  AC negative: outside.  The signs
/ of the two products mostly decide; only if they are unlike is it worked out.
/ In: spx spy, the edge by getedg.  Out: AC.  Destroys: acch accl smb.
side2,  0
        lac spx
        tad neax
        dac eu
        lac spy
        tad neay
        dac ev
        sna
        jmp sidzer      / dx*v = 0
        xor edx
        spa
        jmp sidneg      / dx*v < 0
        lac eu          / dx*v > 0
        sna
        jmp i side2
        xor edy
        spa
        jmp sidin
        jmp sidful
sidzer, lac eu
        sna
        jmp i side2
        xor edy
        spa
        jmp sidin
        jmp sidout
sidneg, lac eu
        sna
        jmp sidout
        xor edy
        sma
        jmp sidout
sidful, jms dist2
        lac acch
        jmp i side2
sidin,  lac (0
        jmp i side2
sidout, clc
        jmp i side2

/ Distance of (spx, spy) from the edge, a double word:
/ dx*(p.y-a.y) - dy*(p.x-a.x)
/ In: spx spy, the edge by getedg.  Out: acch accl.  Destroys: smb.
dist2,  0
        dzm acch
        dzm accl
        lac spy
        tad neay
        dac smb
        lac edx
        jms addprd
        lac spx
        tad neax
        dac smb
        lac nedy
        jms addprd
        jmp i dist2

/ Accumulator + AC * smb, both signed and below 1024 points.
        IFNZRO EAE <
/ The machine multiplies unsigned words and adds AC to the product.  A negative
/ factor is 2^18 too much, which the other one takes back from the high word.
/ In: AC, smb, acch accl.  Out: acch accl; smb is kept.  Destroys: nothing else.
addprd, 0
        dac sma1
        lmq
        lac accl
        cll
        mulac
smb,    0
        tad acch
        dac acch
        lacq
        dac accl
        lac sma1
        sma
        jmp apsmb
        lac smb
        cma
        tad (1
        tad acch
        dac acch
apsmb,  lac smb
        sma
        jmp i addprd
        lac sma1
        cma
        tad (1
        tad acch
        dac acch
        jmp i addprd
        >
        IFZERO EAE <
/ The product comes times 2^(8-FRACTION); only signs and ratios are ever used.
addprd, 0
        dac sma1
        xor smb
        dac smsign
        lac smb
        sma
        jmp .+3
        cma
        tad (1
        dac mpyb
        lac sma1
        sma
        jmp .+3
        cma
        tad (1
        jms mpy
        lac smsign
        sma
        jmp apadd
        jms cmpacc      / a - p = ~(~a + p)
        jms adddbl
        jms cmpacc
        jmp i addprd
apadd,  jms adddbl
        jmp i addprd

/ In: mpyh mpyl, acch accl.  Out: acch accl.  Destroys: nothing else.
adddbl, 0
        lac mpyl
        cll
        tad accl
        dac accl
        glk
        tad mpyh
        tad acch
        dac acch
        jmp i adddbl

/ In: acch accl.  Out: acch accl.  Destroys: nothing else.
cmpacc, 0
        lac accl
        cma
        dac accl
        lac acch
        cma
        dac acch
        jmp i cmpacc
smb,    0
smsign, 0
        >

dp,     0
dq,     0
sida,   0
spx,    0
spy,    0
neax,   0               / minus the start of the edge
neay,   0
edx,    0               / its vector
edy,    0
nedy,   0
eu,     0
ev,     0
acch,   0               / double accumulator
accl,   0
numh,   0
numl,   0
denh,   0
denl,   0
crx,    0
cry,    0
nsl,    0
sma1,   0
