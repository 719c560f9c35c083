/ Tape 3: arithmetic

mull=673122             / MUL that clears the link first; AC is not negative
mulac=640122            / MUL that keeps AC: it is added to the product

/ The angle's quadrant, the multipliers of forms, and the constants added to them.
/ In: angle.
/ Out: kform, kplace, maska, maskb, the multipliers.
/ Destroys: 10 n t1 t2 mx; without the EAE also mpyb mr genret.
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
        jmp sinacs
        xor (377777
        dac maska       / A in 1 and 2
        lac sinev       / in 1 and 3 the sine multiplies A
        dac t1
        lac cosv
        jmp sinmul
sinacs, lac cosv
        dac t1
        lac sinev
sinmul, IFNZRO EAE <
        alss 4
        dac mulbp
        dac mulbf
        lac t1
        alss 4
        dac mulap
        dac mulaf
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
/ In: AC.  Out: AC.  Destroys: mx; without the EAE also mpyb mr n.
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
/ In: AC, jbase, the multipliers by sines.
/ Out: AC.
/ Destroys: 12 t1; without the EAE also mx mr nd quot.
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
        jmp jneg
        dac jd
        lac jn
        jmp jdivid
jneg,   cma
        dac jd
        lac jn
        cma
jdivid, spa
        cla
        IFNZRO EAE <
        670315          / FRDIV of 13 steps that clears the link first
jd,     0
        szl
        jmp jend
        lacq
        jmp i junct
jend,   lac (7777       / N >= D
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
        jmp jend
        dzm quot
        lac (777764     / 12 bits
        dac t1
jbit,   lac mr
        rcl
        dac mr
        tad nd
        szl
        dac mr
        lac quot
        ral
        dac quot
        isz t1
        jmp jbit
        jmp i junct
jend,   lac (7777
        jmp i junct
jd,     0
mr,     0
nd,     0
        >

/ AC = the form behind 12.
/ In: 12, the multipliers by sines.
/ Out: AC, 12.
/ Destroys: t1; without the EAE also mx.
form,   0
        lac i 12
        xor maska
        IFNZRO EAE <
        mull
mulaf,  0
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
mulbf,  0
        >
        IFZERO EAE <
        dac mx
        jms mulb
        >
        tad t1
        tad kform
        jmp i form

/ tplace = the place on the edge at AC, in 4096ths and a half.
/ In: AC, px py sx sy spanx spany.
/ Out: tplace.
/ Destroys: without the EAE mpyb mr nd t2.
locate, 0
        IFNZRO EAE <
        alss 6
        tad (40
        dac locmy
        dac locmx
        lac spany
        lmq
        lac (400000     / half, to round
        cll
        mulac
locmy,  0
        xor sy
        tad py
        dac tplace
        lac spanx
        lmq
        lac (400000
        cll
        mulac
locmx,  0
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
locbit, lac mpyb
        rcr
        dac mpyb
        snl
        jmp loczer
        lac mr
        tad spany
        rcr
        dac mr
        lac nd
        tad spanx
        rcr
        dac nd
        isz t2
        jmp locbit
        jmp locdon
loczer, lac mr
        rcr
        dac mr
        lac nd
        rcr
        dac nd
        isz t2
        jmp locbit
locdon, lac mr
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
/ In: AC, mx, mpyb, n.  Out: AC.  Destroys: mpyb mr n.
mpy,    0
        dac mr
mpystp, lac mpyb
        rcr
        dac mpyb
        lac mr
        szl
        tad mx
        rcr
        dac mr
        isz n
        jmp mpystp
        jmp i mpy
mpyb,   0

/ quot, share = quotient and remainder of 127 AC by major, AC not above it, both
/ below 1024: seven steps; the quotient enters the word from the right as zeros
/ leave room.
/ In: AC, nmajor.  Out: quot, share.  Destroys: mr nd t2.
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
divstp, lac mr
        rcl
        dac mr
        tad nd
        spa
        jmp divnxt
        dac mr
divnxt, isz t2
        jmp divstp
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
/ In: AC, 10, genret.  Out: 10 at the routine's last word.  Destroys: mpyb n.
gen,    0
        dac mpyb
        lac (777762     / 14 bits
        dac n
        lac clear
        dac i 10
genzer, lac mpyb
        rcr
        dac mpyb
        szl
        jmp genadd
        isz n
        jmp genzer
        jmp genend
genbit, lac mpyb
        rcr
        dac mpyb
        snl
        jmp genshf
genadd, lac addmx
        dac i 10
genshf, lac shift
        dac i 10
        isz n
        jmp genbit
genend, lac genret
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
