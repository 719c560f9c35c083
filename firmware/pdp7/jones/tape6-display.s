/ Tape 6: display file

/ Begin the file that is not shown: parameter word (pen off, scale 0,
/ intensity 7) and stop.
/ In: file.  Out: dfs 14 stopad room lastpx.  Destroys: nothing else.
newfil, 0
        lac file
        sad (filea
        jmp nfileb
        lac (filea
        skp
nfileb, lac (fileb
        dac dfs
        tad (777777
        dac 14
        lac (10117
        dac i 14
        lac (3000
        dac i 14
        lac 14
        dac stopad
        lac (filsiz-2
        dac room
        clc             / nothing to join to
        dac lastpx
        jmp i newfil

/ Add the line A-B to the file.
/ In: lax lay lbx lby, cx2, mode, the file.
/ Out: 14 room stopad lastpx lastpy; lax lay lbx lby are kept.
/ Destroys: t1 t3 t4 t5 mdm mdd pdx pdy pxsign pysign pk pwords firstw vsign vwx
/   vwy; file if lines are shown at once.
piece,  0
        lac lax
        tad cx2
        IFNZRO FRACTION <
        rcr
        >
        IFNZRO FRACTION&2 <
        rcr
        >
        IFZERO FRACTION-3 <
        rcr
        >
        dac pax
        lac lbx
        tad cx2
        IFNZRO FRACTION <
        rcr
        >
        IFNZRO FRACTION&2 <
        rcr
        >
        IFZERO FRACTION-3 <
        rcr
        >
        dac pbx
        lac lay
        tad (u1000+uhalf
        IFNZRO FRACTION <
        rcr
        >
        IFNZRO FRACTION&2 <
        rcr
        >
        IFZERO FRACTION-3 <
        rcr
        >
        dac pay
        lac lby
        tad (u1000+uhalf
        IFNZRO FRACTION <
        rcr
        >
        IFNZRO FRACTION&2 <
        rcr
        >
        IFZERO FRACTION-3 <
        rcr
        >
        dac pby
        lac pax
        cma
        tad (1
        tad pbx
        jms signmg
        dac pdx
        lac t3
        dac pxsign      / 200 if to the left
        lac pay
        cma
        tad (1
        tad pby
        jms signmg
        dac pdy
        lac t3
        cll
        rtl
        rtl
        rtl
        rtl
        dac pysign      / 100000 if down
        lac pdx
        sna
        lac pdy
        sna
        jmp i piece     / no length: the 340 would light nothing
        lac pdy         / k = longer of the two, over 127, up
        cma
        tad (1
        tad pdx
        spa
        jmp pcylen
        lac pdx
        skp
pcylen, lac pdy
        dzm pk
pcwrds, isz pk
        tad (777601     / -127
        sma sza
        jmp pcwrds
        lac pk
        dac pwords
        lac mode
        and (2
        sza
        jmp pcpnt
        lac pax
        sad lastpx
        skp
        jmp pcpnt
        lac pay
        sad lastpy
        jmp joined
pcpnt,  lac pk
        tad (3
        dac pwords
        jms roomy
        lac (20000      / next mode point
        dac firstw
        lac pay
        xor (220000     / y, next mode point
        dac i 14
        lac pax
        xor (102000     / x, lit, next mode vector
        dac i 14
        jms vwords
        jmp pcstop
joined, jms roomy
        lac 14
        tad (777777
        dac t1
        lac i t1        / the piece before goes on: take its escape back
        and (377777
        dac i t1
        dzm firstw
        jms vwords
pcstop, lac (3000       / the new stop first,
        dac i 14
        lac firstw
        dac i stopad    / the old one last
        lac 14
        dac stopad
        lac pbx
        dac lastpx
        lac pby
        dac lastpy
        lac mode
        and (2
        sna
        jmp i piece
        lac dfs
        sad file
        jmp i piece
        jms show        / lines added at once: show the first
        jmp i piece

/ In: pwords, room.
/ Out: room.
/ Destroys: nothing else; leaves by flt2 if the file is full.
roomy,  0
        lac pwords
        cma
        tad (1
        tad room
        spa
        jmp flt2
        dac room
drawn,  jmp i roomy

/ In: AC.  Out: AC, t3.  Destroys: t4.
signmg, 0               / AC = |AC|, t3 = 200 if it was negative
        dzm t3
        sma
        jmp i signmg
        dac t4
        lac (200
        dac t3
        lac t4
        cma
        tad (1
        jmp i signmg

/ pk vector words; the last one escapes.  If firstw is 0 the first of them
/ goes there.
/ In: pdx pdy pxsign pysign pk firstw 14.
/ Out: 14, firstw.
/ Destroys: t5 mdm mdd vsign vwx vwy.
vwords, 0
        lac pxsign
        xor pysign
        xor (200000
        dac vsign
        dzm psx
        dzm psy
        dzm pi
        lac pk
        sad (1
        jmp vwlast
        dac mdd
vwnext, isz pi
        lac pi
        sad pk
        jmp vwlast
        dac mdm
        lac pdx
        jms muldiv
        dac t5
        lac psx
        cma
        tad (1
        tad t5
        dac vwx
        lac t5
        dac psx
        lac pdy
        jms muldiv
        dac t5
        lac psy
        cma
        tad (1
        tad t5
        dac vwy
        lac t5
        dac psy
        jms vput
        jmp vwnext
vwlast, lac psx
        cma
        tad (1
        tad pdx
        dac vwx
        lac psy
        cma
        tad (1
        tad pdy
        dac vwy
        lac vsign
        xor (400000
        dac vsign
        jms vput
        jmp i vwords

/ In: vwx vwy vsign firstw 14.  Out: 14 or firstw.  Destroys: t5.
vput,   0
        lac vwy
        rtl
        rtl
        rtl
        rtl
        and (77400
        xor vwx
        xor vsign
        dac t5
        lac firstw
        sza
        jmp vpfile
        lac t5
        dac firstw
        jmp i vput
vpfile, lac t5
        dac i 14
        jmp i vput

dfs,    0               / first word of the file being made
stopad, 0               / its stop word
room,   0
lastpx, 0               / where the last piece ended
lastpy, 0
pax,    0
pay,    0
pbx,    0
pby,    0
pdx,    0
pdy,    0
pxsign, 0
pysign, 0
pk,     0
pi,     0
pwords, 0
firstw, 0
vsign,  0
psx,    0
psy,    0
vwx,    0
vwy,    0
