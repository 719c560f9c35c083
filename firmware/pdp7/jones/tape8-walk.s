/ Tape 8: the walk
/
/ Only with WALK=1.  Jones left out the planes of the cells, and with them the
/ freedom to leave the initial cell.  Here the scene tape has them: a cell's
/ origin is one corner of its box, and the three words before it are the corner
/ opposite, one word for each plane.  The openings come before the cells, each
/ with its record (tape 2) before it, which takes less core than the table.

        IFNZRO WALK <

/ A view begins: find the cell of the eye if none is known, then take the steps
/ along x, y and z, one after the other.  scene is the cell, scene+5.. the box
/ in which the eye may be there.
/ In: ex ey ez step, scene tape; scene 0 if the cell is not known.
/ Out: ex ey ez, scene and scene+5.., stops.
/ Destroys: 10-13 15 16, nex ney nez cell lp elem org ext and what plane and
/   extent destroy; leaves by fault on a bad element or without a cell.
travel, 0
        dzm stops
        IFNZRO ROTATE <
        jms newdir
        >
        lac scene
        sna
        jms locate
        dac cell
        dzm scene       / none, if a bad element ends the view here
        lac (ex-1
        jms keepin
        lac (ex
        dac wkeye
        lac (step
        dac wkstep
        lac (ext
        dac wkext
        lac (1
travax, dac wkbit
        lac i wkstep
        sza
        jms leg
        isz wkeye
        isz wkstep
        isz wkext
        isz wkext
        lac wkbit
        rcl
        sad (10
        skp
        jmp travax
        lac cell
        dac scene
        jmp i travel

/ One leg, along one axis: AC = its steps.  It goes through each opening whose
/ plane it reaches; where there is none the next wall ends it.
/ In: AC, cell, the eye with nex.., wkeye wkstep wkext wkbit.
/ Out: the eye, cell, stops.
/ Destroys: as travel.
leg,    0
        tad i wkeye
        dac target
        dzm passed
legcel, lac cell        / between the planes of the cell the leg ends
        tad wkeye
        tad (-ex+1
        dac t1
        lac i t1
        cma
        tad (1
        tad target
        sna
        jmp legscn
        dac wkout
        lac t1
        tad (-3+1
        dac t1
        lac i t1
        cma
        tad (1
        tad target
        sna
        jmp legscn
        xor wkout
        spa
        jmp legend
legscn, jms list
legopn, isz lp
        lac i lp
        and (17777
        sna
        jmp legend      / the cell has no openings
        dac elem
        tad (1
        dac org
        lac i elem
        spa
        isz org
        lac org         / is its origin, and so its plane, ahead?
        tad wkeye
        tad (-ex+1
        dac t1
        lac i t1
        cma
        tad (1
        tad i wkeye
        dac t1
        tad passed
        sna
        jmp legnot
        xor i wkstep
        sma
        jmp legnot
        lac t1          / and reached?
        tad i wkstep
        sna
        jmp leghit
        xor i wkstep
        spa
        jmp legnot
leghit, jms plane
        jms extent
        lac (ext-1      / the eye must be between its other sides;
        dac 15          / on a line between two openings it is in the high one
        lac (-3+1
        dac cnt
legaxi, lac 15
        tad (1
        sad wkext
        jmp legown
        lac i 15
        tad (777777
        sma
        jmp legnot
        lac i 15
        tad (777777
        spa
        jmp legnot
legnxt, isz cnt
        jmp legaxi
        lac i wkext     / through it
        dac passed
        lac i elem
        and (17777
        dac cell
        jmp legcel
legown, tad (1          / the leg's own axis
        dac 15
        jmp legnxt
legnot, lac i lp        / not this one
        sma
        jmp legopn
legend, lac target
        dac i wkeye
        lac (ex-1
        jms keepin
        lac target      / did a wall hold the eye back?
        cma
        tad (1
        tad i wkeye
        sna
        jmp i leg
        xor i wkstep
        sma
        jmp i leg       / no: a plane pushed it on
        lac stops
        tad wkbit
        dac stops
        jmp i leg

/ AC = the cell in which the eye is: that with the eye between its planes.
/ In: ex ey ez, scene tape.
/ Out: AC, cell, scene+5..; leaves by fault without a cell.
/ Destroys: 10-13 15 16, nex.. ext lp t1 wkbit and what keepin destroys.
locate, 0
        lac scene+1
        cma
        tad (1
        sna
        jmp locnon
        dac wkbit
        lac (c0
loccel, dac cell
        lac (ext-1
        jms keepin
        sna
        jmp locfnd
        jms list        / the next cell begins behind its list
loclst, isz lp
        lac i lp
        sma
        jmp loclst
        lac lp
        tad (4
        isz wkbit
        jmp loccel
locnon, lac (7          / in a solid, on a plane or outside
        jmp fault
locfnd, lac cell
        jmp i locate

/ lp = the word before the list of the cell's openings.
/ In: cell.
/ Out: lp.
/ Destroys: t1.
list,   0
        lac cell
        tad (3
        dac t1
        lac i t1
        tad t1
        dac lp
        jmp i list

/ Move the eye inside the cell: it goes where AC points before, minus it to nex;
/ scene+5.. = the box, each plane less 1.  AC = 0 if the eye was inside.
/ In: AC, cell, ex ey ez.
/ Out: AC, the three words behind AC, nex ney nez, scene+5..
/ Destroys: 10-13 15 16, cnt t1 limlo limhi limt wkout; leaves by fault if the
/   planes have no point between them.
keepin, 0
        dac 16
        dzm wkout
        lac cell
        tad (777777
        dac 15
        tad (-3+1
        dac 11
        lac (ex-1
        dac 12
        lac (nex-1
        dac 13
        lac (scene+4
        dac 10
        lac (-3+1
        dac cnt
keepax, lac i 15        / two planes: which is the low one?
        dac limlo
        lac i 11
        dac limhi
        cma
        tad (1
        tad limlo
        spa
        jmp keepok
        lac limhi
        dac t1
        lac limlo
        dac limhi
        lac t1
        dac limlo
keepok, lac limlo
        tad (1
        dac limlo
        dac i 10
        lac limhi
        tad (777777
        dac limhi
        dac i 10
        cma
        tad (1
        tad limlo
        sma sza
        jmp flt6        / too thin for a point inside
        lac i 12
        jms limit
        dac i 16
        sad limt
        skp
        isz wkout
        cma
        tad (1
        dac i 13
        isz cnt
        jmp keepax
        lac wkout
        jmp i keepin

step,   0               / how far the eye is to go along each axis
        0
        0
        IFNZRO ROTATE <
        0               / and by how many degrees it is to turn
        >
stops,  0               / 1, 2, 4: a wall ended the leg along x, y, z
target, 0               / where the leg would end
passed, 0               / the last plane passed, as seen from where the leg began
wkeye,  0               / words of the leg's axis: the eye
wkstep, 0               / its steps
wkext,  0               / its extent of an opening, low end and high end
wkbit,  0               / its bit of stops
wkout,  0               / how many coordinates keepin has moved
        >
