/ Tape 7: arithmetic

        IFNZRO EAE <
/ AC = (AC*b + c/2)/c, b in mdm, c in mdd; all positive, c below 2^17.  Half of
/ c is left out where quotients are cut off, here and below.
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
        jms muldv1
        jmp i muldiv
muldb,  lac mdm
        jmp i muldiv
mulda,  lac mds
        jmp i muldiv

/ The loop: AC = a, not 0; b in mdm, less than c; -c in mdnc.
muldv1, 0
        stl             / a one behind the last bit ends the loop
        ral
        dac mds
        dzm mdq
muld1,  rcl             / bring the first bit of a to the left end,
        snl
        jmp muld1
        dac mds         / and past it: q = 0, r = b
        lac mdm
        dac mdr
        jmp muld5
muld2,  lac mdr         / r = 2r, q = 2q, less c if it goes
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
        jmp muld4
        lac mdr         / a bit: r = r+b
        tad mdm
        dac mdr
        tad mdnc
        snl
        jmp muld4
        dac mdr
        isz mdq
muld4,  lac mds
        rcl
        dac mds
muld5,  lac mds
        sad (400000
        skp
        jmp muld2
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
        jmp i muldv1

/ mpyh,mpyl = AC * mpyb * 2^(8-FRACTION), both below 1024 points: one step for
/ each bit, the multiplier leaving the low word to the right as the product
/ enters it from the left.
mpy,    0
        dac mpya
        dzm mpyh
        lac (777766-FRACTION
        dac mpyn
        lac mpyb
        rcr
        dac mpyl
mpy1,   lac mpyh
        szl cll
        tad mpya
        rar
        dac mpyh
        lac mpyl
        rar
        dac mpyl
        isz mpyn
        jmp mpy1
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
