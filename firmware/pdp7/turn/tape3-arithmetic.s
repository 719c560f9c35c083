/ Tape 3: arithmetic

mull=673122             / MUL that clears the link first; AC is not negative
mulac=640122            / MUL that keeps AC: it is added to the product

/ The angle's quadrant, the multipliers of forms, and the constants added to them.
sines,  0
        lac angle
        and (177777
        jms sine
        dac sinev
        lac angle
        and (177777
        cma
        tad (200001     / a quarter turn less it
        jms sine
        dac cosv
        lac cosv
        tad sinev
        rcl
        ral
        cma
        tad (3
        dac kform       / 2 - 4(c+s)
        tad (200100     / the middle of the screen, and half a point
        dac kplace
        lac angle
        rtl             / bit 1 to L, bit 0 to AC 17
        and (1
        sza
        lac (377777
        dac maskb       / B is taken negative in quadrants 2 and 3
        dac maska
        snl
        jmp sines2
        xor (377777
        dac maska       / A in 1 and 2
        lac sinev       / in 1 and 3 the sine multiplies A
        dac t1
        lac cosv
        jmp sines4
sines2, lac cosv
        dac t1
        lac sinev
sines4, IFNZRO EAE <
        alss 4
        dac mulb1
        dac mulb2
        lac t1
        alss 4
        dac mula1
        dac mula2
        >
        IFZERO EAE <
        dac t2
        lac (mulb
        dac 10
        lac jmpmlb
        dac genret
        lac t2
        jms gen
        lac (mula
        dac 10
        lac jmpmla
        dac genret
        lac t1
        jms gen
        >
        jmp i sines

/ AC = 2^14 sin(AC), AC from 0 to a quarter turn.  Between the table's words in a
/ straight line.
sine,   0
        dac sinea
        IFNZRO EAE <
        cll
        lrs 11
        >
        IFZERO EAE <
        rtr
        rtr
        rtr
        rtr
        rar
        and (777
        >
        tad (sintab
        dac sinep
        lac i sinep
        dac sinet
        cma
        tad (1
        isz sinep
        tad i sinep
        dac mx          / how far it is to the next word
        lac sinea
        and (777
        IFNZRO EAE <
        alss 11
        dac sinem
        lac mx
        mull
sinem,  0
        >
        IFZERO EAE <
        dac mpyb
        lac (777767     / 9 bits
        dac n
        cla
        jms mpy
        >
        tad sinet
        tad (4
        rcr
        rcr
        rcr
        sad (40000
        lac (37777
        jmp i sine

/ AC = where on the edge a junction is, in 4096ths, 0 to 4095.  AC = its number,
/ in bits 0-5: N over D, or 0 if N is not of D's sign.
junct,  0
        rtl
        rtl
        rtl
        rtl
        ral
        and (374
        tad jbase
        dac 12
        jms form
        dac jn
        jms form
        spa
        jmp junc1
        dac jd
        lac jn
        jmp junc2
junc1,  cma
        dac jd
        lac jn
        cma
junc2,  spa
        cla
        IFNZRO EAE <
        670315          / FRDIV of 13 steps that clears the link first
jd,     0
        szl
        jmp junc3
        lacq
        jmp i junct
junc3,  lac (7777       / N >= D
        jmp i junct
        >
        IFZERO EAE <
        dac mr
        lac jd
        cma
        tad (1
        dac nd
        tad mr
        sma
        jmp junc3
        dzm quot
        lac (777764     / 12 bits
        dac t1
junc4,  lac mr
        rcl
        dac mr
        tad nd
        szl
        dac mr
        lac quot
        ral
        dac quot
        isz t1
        jmp junc4
        jmp i junct
junc3,  lac (7777
        jmp i junct
jd,     0
mr,     0
nd,     0
        >

/ AC = the form behind 12.
form,   0
        lac i 12
        xor maska
        IFNZRO EAE <
        mull
mula2,  0
        >
        IFZERO EAE <
        dac mx
        jms mula
        >
        dac t1
        lac i 12
        xor maskb
        IFNZRO EAE <
        mull
mulb2,  0
        >
        IFZERO EAE <
        dac mx
        jms mulb
        >
        tad t1
        tad kform
        jmp i form

/ tplace = the place on the edge at AC, in 4096ths and a half.
locate, 0
        IFNZRO EAE <
        alss 6
        tad (40
        dac loc1
        dac loc2
        lac spany
        lmq
        lac (400000     / half, to round
        cll
        mulac
loc1,   0
        xor sy
        tad py
        dac tplace
        lac spanx
        lmq
        lac (400000
        cll
        mulac
loc2,   0
        >
        IFZERO EAE <
        stl
        ral
        dac mpyb        / 2s+1
        lac (777763     / 13 bits
        dac t2
        lac (10000      / half of 2^13, to round
        dac mr
        dac nd
loc1,   lac mpyb
        rcr
        dac mpyb
        snl
        jmp loc2
        lac mr
        tad spany
        rcr
        dac mr
        lac nd
        tad spanx
        rcr
        dac nd
        isz t2
        jmp loc1
        jmp loc3
loc2,   lac mr
        rcr
        dac mr
        lac nd
        rcr
        dac nd
        isz t2
        jmp loc1
loc3,   lac mr
        xor sy
        tad py
        dac tplace
        lac nd
        >
        xor sx
        tad px
        dac tplace+1
        jmp i locate

        IFZERO EAE <
/ AC = (AC + mx*mpyb) >> bits, -bits in n: one step for each bit of mpyb.
mpy,    0
        dac mr
mpy1,   lac mpyb
        rcr
        dac mpyb
        lac mr
        szl
        tad mx
        rcr
        dac mr
        isz n
        jmp mpy1
        jmp i mpy
mpyb,   0

/ quot, share = quotient and remainder of 127 AC by major, AC not above it, both
/ below 1024: seven steps; the quotient enters the word from the right as zeros
/ leave room.
divid,  0
        dac t2
        rcl
        rtl
        rtl
        rtl
        and (777600
        dac mr          / 128 AC
        lac t2
        cma
        tad (1
        tad mr
        dac mr
        lac nmajor
        rcl
        rtl
        rtl
        rtl
        and (777600
        tad (1
        dac nd          / 1 - 128 major
        lac (777771
        dac t2
divi1,  lac mr
        rcl
        dac mr
        tad nd
        spa
        jmp divi2
        dac mr
divi2,  isz t2
        jmp divi1
        lac mr
        and (177
        dac quot
        lac mr
        rtr
        rtr
        rtr
        rar
        and (3777
        dac share
        jmp i divid

/ Makes the multiplication by AC behind 10: mx times AC over 2^14, cut off.  A bit
/ that is set adds mx, every bit shifts; nothing is done before the first one set.
gen,    0
        dac mpyb
        lac (777762     / 14 bits
        dac n
        lac clear
        dac i 10
gen1,   lac mpyb
        rcr
        dac mpyb
        szl
        jmp gen3
        isz n
        jmp gen1
        jmp gen5
gen2,   lac mpyb
        rcr
        dac mpyb
        snl
        jmp gen4
gen3,   lac addmx
        dac i 10
gen4,   lac shift
        dac i 10
        isz n
        jmp gen2
gen5,   lac genret
        dac i 10
        jmp i gen
clear,  cla
addmx,  tad mx
shift,  rcr
jmpmla, jmp i mula
jmpmlb, jmp i mulb
genret, 0
mula,   0               / 30 words made by gen
.+36/
mulb,   0
.+36/
        >
mx,     0
jn,     0
cosv,   0
sinev,  0
sinea,  0
sinep,  0
sinet,  0
