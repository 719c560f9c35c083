/ Tape 7: arithmetic

        IFNZRO EAE <
/ AC = (AC*b + c/2)/c, b in mdm, c in mdd; all positive, c below 2^17.  Half of
/ c is left out where quotients are cut off, here and below.
/ In: AC, mdm, mdd.
/ Out: AC; mdm and mdd are kept.
/ Destroys: nothing else; leaves by flt3 if the quotient is too large.
muldiv, 0
        sna
        jmp i muldiv
        sad mdd         / c*b/c
        jmp muldb
        lmq
        lac mdd
        dac mdc
        rcr
        dac mdt
        lac mdm
        dac mdb
        IFZERO TRUNCATE <
        lac mdt         / mulac adds it to the product
        >
        IFNZRO TRUNCATE <
        lac (0
        >
        cll
        mulac
mdb,    0
        div
mdc,    0
        szl
        jmp flt3
        lacq
        jmp i muldiv
muldb,  lac mdm
        jmp i muldiv
mdt,    0
        >
        IFZERO EAE <
/ AC = (AC*b + c/2)/c, b in mdm, c in mdd; all positive, b not above c, c below
/ 2^17.  The bits of AC from the left: quotient q and remainder r are doubled,
/ and b is added where there is a bit, so that nothing needs a double word.
muldiv, 0
        sna
        jmp i muldiv
        sad mdd         / c*b/c
        jmp muldb
        dac mds
        lac mdd
        sad mdm         / a*c/c
        jmp mulda
        cma
        tad (1
        dac mdnc
        lac mds
        jms mdloop
        jmp i muldiv
muldb,  lac mdm
        jmp i muldiv
mulda,  lac mds
        jmp i muldiv

/ The loop: AC = a, not 0; b in mdm, less than c; -c in mdnc.
/ In: AC, mdm, mdnc.  Out: AC.  Destroys: nothing else.
mdloop, 0
        stl             / a one behind the last bit ends the loop
        ral
        dac mds
        dzm mdq
mdfrst, rcl             / bring the first bit of a to the left end,
        snl
        jmp mdfrst
        dac mds         / and past it: q = 0, r = b
        lac mdm
        dac mdr
        jmp mdtest
mdstep, lac mdr         / r = 2r, q = 2q, less c if it goes
        rcl
        dac mdr
        tad mdnc
        szl
        dac mdr
        lac mdq
        ral
        dac mdq
        lac mds
        sma
        jmp mdnext
        lac mdr         / a bit: r = r+b
        tad mdm
        dac mdr
        tad mdnc
        snl
        jmp mdnext
        dac mdr
        isz mdq
mdnext, lac mds
        rcl
        dac mds
mdtest, lac mds
        sad (400000
        skp
        jmp mdstep
        IFZERO TRUNCATE <
        lac mdr         / rounding: one more doubling
        rcl
        tad mdnc
        lac mdq
        szl
        tad (1
        >
        IFNZRO TRUNCATE <
        lac mdq
        >
        jmp i mdloop

/ mpyh,mpyl = AC * mpyb * 2^(8-FRACTION), both below 1024 points; with ROTATE
/ AC * mpyb, any two words: one step for each bit, the multiplier leaving the low word to the right as the product
/ enters it from the left.
/ In: AC, mpyb.  Out: mpyh mpyl.  Destroys: nothing else.
mpy,    0
        dac mpya
        dzm mpyh
        IFZERO ROTATE <
        lac (777766-FRACTION
        >
        IFNZRO ROTATE <
        lac (777756     / all 18 bits
        >
        dac mpyn
        lac mpyb
        rcr
        dac mpyl
mpystp, lac mpyh
        szl cll
        tad mpya
        rar
        dac mpyh
        lac mpyl
        rar
        dac mpyl
        isz mpyn
        jmp mpystp
        jmp i mpy
mpya,   0
mpyn,   0
mpyb,   0
mpyh,   0
mpyl,   0
mds,    0
mdq,    0
mdr,    0
mdnc,   0
        >
mdm,    0
mdd,    0
