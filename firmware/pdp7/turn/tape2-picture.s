/ Tape 2: the picture
/
/ A form is two words A', B' for the function A cos(angle) + B sin(angle), A being
/ A'-65535.5.  A place is a Y word of the display and an X.  A slot is what is seen
/ of an edge, or one piece of it: state, place of its first vertex, of its second
/ (both less 1), forms of its junctions (less 9).

/ The X of every vertex.
/ In: the multipliers by sines, nverts, forms, placs.
/ Out: the X of every place.
/ Destroys: 11 12 n t1 mx.
places, 0
        lac forms
        dac 11
        lac placs
        dac 12
        lac nverts
        dac n
        IFNZRO EAE <
plnext, lac i 11
        xor maska
        mull
mulap,  0
        dac t1
        lac i 11
        xor maskb
        mull
mulbp,  0
        tad t1
        tad kplace
        lrss 7
        >
        IFZERO EAE <
plnext, lac i 11
        xor maska
        dac mx
        jms mula
        dac t1
        lac i 11
        xor maskb
        dac mx
        jms mulb
        tad t1
        tad kplace
        rtr
        rtr
        rtr
        rar
        and (1777
        >
        isz 12
        dac i 12
        isz n
        jmp plnext
        jmp i places

/ All slots, or with a wire frame the first of every edge.
/ In: slots, slotn, wirsw, 14, room.
/ Out: 14; status = 2 if the file is full.
/ Destroys: 10 11 12 n lastv state vp vq jbase codea codeb sa sb, what first,
/   vector, span, junct and locate write.
pieces, 0
        lac slots
        tad (777777
        dac 10
        lac slotn
        dac n
slot,   lac i 10
wirsw,  sad whole       / jmp fast with a wire frame
        jmp fast
        sza
        jmp partly
        lac 10          / nothing is seen
        tad (3
        dac 10
next,   isz n
        jmp slot
        jmp i pieces

fast,   lac 14
        tad room
        sma
        jmp full
        lac i 10
        sad lastv       / the line goes on where the last one ended
        jmp fastto
        dac 11
        jms first
fastto, lac i 10
        dac lastv
        dac 11
        isz 10
        jms vector
        isz n
        jmp slot
        jmp i pieces

full,   lac (2          / the picture ends here
        dac status
        jmp i pieces

/ Lines begin again at the place behind 11.
/ In: 11, 14.  Out: 11 at the X, 14, ncx ncy.  Destroys: nothing else.
first,  0
        jms escape
        lac (20000      / next mode point
        dac i 14
        lac i 11        / Y
        dac i 14
        cma
        dac ncy
        lac i 11        / X, lit, next mode vector
        xor (102000
        dac i 14
        xor (675777
        dac ncx
        jmp i first

/ To the place behind 11.  Differences are one's complement; 0 is -0.
/ In: 11, 14, ncx ncy.
/ Out: 11 at the X, 14, ncx ncy.
/ Destroys: x y adx ady sign; major minor nmajor chunk unit error share quot if
/   the line is long; without the EAE then also mr nd t2.
vector, 0
        lac i 11
        dac y
        add ncy
        spa
        jmp vdown
        dac ady
        lac (200000     / lit
        jmp vectx
vdown,  cma
        dac ady
        lac (300000     / lit, down
vectx,  dac sign
        lac y
        cma
        dac ncy
        lac i 11
        dac x
        add ncx
        spa
        jmp vleft
        dac adx
        jmp vfits
vleft,  cma
        dac adx
        lac sign
        xor (200        / left
        dac sign
vfits,  lac x
        cma
        dac ncx
        lac adx
        and (1600
        sza
        jmp long
        lac ady
        and (1600
        sza
        jmp long
        lac ady
        IFNZRO EAE <
        alss 10
        >
        IFZERO EAE <
        rcl
        rtl
        rtl
        rtl
        ral
        >
        xor adx
        xor sign
        dac i 14
        jmp i vector

/ Longer than 127: words of 127 along the longer axis, and one with what is left.
/ The other axis has the rounded share of 127, 254, ... of the whole: quotient and
/ remainder of 127 times it by the longer one, the remainders added up.
long,   lac ady
        cma
        tad (1
        tad adx
        spa
        jmp longy
        lac adx
        dac major
        lac ady
        dac minor
        lac (177
        dac chunk
        lac (400
        jmp lngset
longy,  lac ady
        dac major
        lac adx
        dac minor
        lac (77400
        dac chunk
        lac (1
lngset, dac unit
        lac major
        IFNZRO EAE <
        dac divm
        >
        cma
        tad (1
        dac nmajor
        lac major
        rcr
        tad nmajor
        dac error
        lac minor
        IFNZRO EAE <
        mull
        177
        div             / 127 times it is in MQ, AC = 0, L = 0
divm,   0
        dac share
        lacq
        dac quot
        >
        IFZERO EAE <
        jms divid
        >
        lac unit        / the word of a chunk: chunk, sign, quot times unit
        sad (1
        jmp lngqx
        lac quot
        IFNZRO EAE <
        alss 10
        >
        IFZERO EAE <
        rcl
        rtl
        rtl
        rtl
        ral
        >
        jmp lngwrd
lngqx,  lac quot
lngwrd, xor chunk
        xor sign
        dac chunk
lngnxt, lac quot
        cma
        tad (1
        tad minor
        dac minor
        lac error
        tad share
        spa
        jmp lngkp
        tad nmajor
        dac error
        lac minor
        tad (777777
        dac minor
        lac chunk
        tad unit
        jmp lngput
lngkp,  dac error
        lac chunk
lngput, dac i 14
        lac major
        tad (777601     / -127
        dac major
        tad (777600     / more than 127 left?
        sma
        jmp lngnxt
        lac unit        / what is left
        sad (1
        jmp lngrsy
        lac minor
        dac ady
        lac major
        jmp lngrst
lngrsy, lac major
        dac ady
        lac minor
lngrst, dac adx
        lac ady
        IFNZRO EAE <
        alss 10
        >
        IFZERO EAE <
        rcl
        rtl
        rtl
        rtl
        ral
        >
        xor adx
        xor sign
        dac i 14
        jmp i vector

/ A piece with a T-junction.
partly, dac state
        lac 14
        tad room
        sma
        jmp full
        lac i 10
        dac vp
        lac i 10
        dac vq
        lac i 10
        dac jbase
        dzm sa
        lac state
        and (7700
        rcl
        rtl
        rtl
        ral
        dac codeb
        lac state
        and (770000
        dac codea
        sad (10000
        jmp partb
        jms junct
        dac sa
partb,  lac codeb
        sad (10000
        jmp partsp
        jms junct
        dac sb
        cma             / nothing left between the two?
        tad (1
        tad sa
        sma
        jmp next
partsp, jms span
        lac codea
        sad (10000
        jmp partvp
        lac sa
        jms locate
        lac (tplace-1
        jmp partfs
partvp, lac vp
        sad lastv
        jmp partto
partfs, dac 11
        jms first
partto, lac codeb
        sad (10000
        jmp partvq
        lac sb
        jms locate
        dzm lastv
        lac (tplace-1
        jmp partln
partvq, lac vq
        dac lastv
partln, dac 11
        jms vector
        jmp next

/ The edge from vp to vq: its first place, and how far it goes.
/ In: vp, vq.  Out: px py sx sy spanx spany.  Destroys: 11 t1 t2.
span,   0
        lac vp
        dac 11
        lac i 11
        dac py
        cma
        tad (1
        dac t1
        lac i 11
        dac px
        cma
        tad (1
        dac t2
        lac vq
        dac 11
        dzm sx
        dzm sy
        lac i 11
        tad t1
        sma
        jmp spandy
        cma
        tad (1
        isz py          / -r is the complement of r, and 1
        isz sy
spandy, dac spany
        lac i 11
        tad t2
        sma
        jmp spandx
        cma
        tad (1
        isz px
        isz sx
spandx, dac spanx
        lac sx
        cma
        tad (1
        dac sx          / 777777 if to the left
        lac sy
        cma
        tad (1
        dac sy
        jmp i span

/ Variables of this tape
whole,  010100          / the state of an edge seen whole
t1,     0
t2,     0
maska,  0               / 377777: the form's first word is taken negative
maskb,  0
kplace, 0
kform,  0
lastv,  0               / place of the vertex where the last line ended
ncx,    0               / complement of where the beam is
ncy,    0
x,      0
y,      0
adx,    0
ady,    0
sign,   0
major,  0
minor,  0
nmajor, 0
chunk,  0
unit,   0
error,  0
share,  0
quot,   0
state,  0
vp,     0
vq,     0
jbase,  0
codea,  0
codeb,  0
sa,     0
sb,     0
px,     0
py,     0
sx,     0
sy,     0
spanx,  0
spany,  0
tplace, 0
        0
