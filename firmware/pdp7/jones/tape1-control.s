/ Jones's hidden-line program for the PDP-7 and Type 340.   Tape 1: control
/
/ Nine tapes, read one after the other, then a scene tape; assembled with
/ EAE=1 or EAE=0.  What each part computes is in SPECIFICATION.md; which term
/ of the paper is which label here, in NOTES.md.  Two's complement throughout;
/ octal; negate is cma, tad (1.
/
/ FRACTION is how many fraction bits a coordinate on the screen has, 0 to 3;
/ TRUNCATE=1 cuts quotients and points off where TRUNCATE=0 rounds them.
/ WALK=1 lets the eye walk from cell to cell (tape 8); its scene tape has the
/ planes of the cells.  ROTATE=1, with WALK=1, turns the view about the vertical
/ (tape 9); the scene tape is that of the walk.
/
/ Core:  00000-00021 interrupt, clock, auto-index   00022- program, scene,
/ constants   10075 records (with WALK they are in the scene)   11446 mask stack
/ 12460 and 15230 the two display files.
/ Auto-index registers: 10 vectors of a chain  11 polygon being written
/ 12 polygon being read  13 sloped edges  14 display file  15,16 copying
/ 17 interrupt handler.
/
/ Before each routine: what it takes (In), what it returns (Out), and what else
/ it writes (Destroys).  Not listed are AC, link and MQ, which every routine
/ destroys; words that only the routine itself uses; and mds mdnc mpyb mpyh mpyl
/ of the arithmetic without the EAE.  The mask is nslope to slopes, the polygon
/ pn pcur palt, the polygon being made 11 lastx lasty pnroom, the file dfs 14
/ stopad room lastpx lastpy.

FRACTION=3
TRUNCATE=0
WALK=0
ROTATE=0
        IFNZRO FRACTION&777774 <
unit=1
uhalf=0
u100=100
        FRACTION-is-not-0-1-2-3
        >
        IFZERO FRACTION <       / a point of the screen, half of it, 64 of it
unit=1
uhalf=0
u100=100
        >
        IFZERO FRACTION-1 <
unit=2
uhalf=1
u100=200
        >
        IFZERO FRACTION-2 <
unit=4
uhalf=2
u100=400
        >
        IFZERO FRACTION-3 <
unit=10
uhalf=4
u100=1000
        >
        IFNZRO TRUNCATE <
uhalf=0
        >
u200=u100+u100
u400=u200+u200
u1000=u400+u400
u2000=u1000+u1000

        IFNZRO ROTATE <
        IFZERO WALK <
        ROTATE-needs-WALK
        >
        >

        IFZERO WALK <
recs=10075              / records of openings: 5 words each
recmax=224              / 148 of them
recend=11441            / and one for an opening beyond these
        >
        IFNZRO WALK <
recs=11446              / each opening has its record before it
        >
stack=11446
stkend=12350            / 450 words; one frame more may be written beyond
filea=12460
fileb=15230
filsiz=2550             / 1384 words each

mulac=640122            / MUL that keeps AC: it is added to the product

0/      0               / interrupt: L and PC
        jmp intr
7/      0               / clock

22/
start,  caf
        dzm runing
        clc
        dac 7
clkop,  clon            / tests deposit clof here
        jms initpr
        lac (fileb
        dac file
        ion

/ One view after the other.
view,   las
        and (3
        dac mode
        jms newpar
vwwait, lac runing      / the display must have taken up the last file
        sna
        jmp search
        lac shown
        sad file
        jmp search
        jmp vwwait

search, dzm status      / the view's time begins here
        jms newfil
        IFNZRO WALK <
        jms travel
        >
        lac mode
        and (1
        sza
        jmp pair
        jms monwin
        jms onepas
        jmp publsh
pair,   jms lefwin
        jms onepas
        jms rigwin
        jms onepas

/ The new file becomes the current one by one store.
publsh, lac dfs
        sad file
        jmp publd       / already shown: lines were added at once
        jms show
publd,  isz views
        nop
        jmp view

fault,  dac status      / anything that stops a view comes here, AC = status
        jmp publsh
flt1,   lac (1
        jmp fault
flt2,   lac (2
        jmp fault
flt3,   lac (3
        jmp fault
flt4,   lac (4
        jmp fault
flt5,   lac (5
        jmp fault
flt6,   lac (6
        jmp fault

/ In: dfs.  Out: file = dfs, and the display runs.  Destroys: nothing else.
show,   0               / make the file at dfs the current one
        lac dfs
        dac file        / the view's time ends here
        lac runing
        sza
        jmp i show
        lac file
        dac shown
        isz runing
        idla
        jmp i show

/ Interrupts: the display stopped, the clock ticked, or something unwanted.
intr,   dac intac
        idsi
        jmp iclock
        lac file
        dac shown
        tad (1
        dac intpt
        lac i intpt
        sad (3000
        jmp iempty      / a picture of nothing: once is enough
        lac file
        idla
        jmp intrx
iclock, clsf
        jmp iother
        jms tick
        jmp intrx
iother, idcf
        krb
        tcf
        pcf
        rcf
        jmp intrx
iempty, idcf            / refreshed, it would leave the program no time
        dzm runing
intrx,  lac 0
        ral             / the link as it was
        lac intac
        ion
        jmp i 0

/ Clock: each of switches 0-7, with ROTATE 0-9, that is up adds its step to a sum.
/ In: the switches.
/ Out: sumx sumy sumz sums, with ROTATE sumt; the clock set again.
/ Destroys: 17.
tick,   0
        clc
        dac 7
        clon
        las
        IFZERO ROTATE <
        and (776000
        >
        IFNZRO ROTATE <
        and (777400
        >
        sna
        jmp i tick
        dac tksw
        lac (tktab-1
        dac 17
        IFZERO ROTATE <
        lac (777770     / eight switches
        >
        IFNZRO ROTATE <
        lac (777766     / ten
        >
        dac tkn
tkeach, lac i 17
        dac tkcell
        lac i 17
        dac tkstep
        lac tksw
        rcl
        dac tksw
        snl
        jmp tknext
        lac i tkcell
        tad tkstep
        dac i tkcell
tknext, isz tkn
        jmp tkeach
        jmp i tick

tktab,  sumx            / left, right
        777777
        sumx
        1
        sumy            / up, down
        1
        sumy
        777777
        sumz            / in, out
        1
        sumz
        777777
        sums            / bigger, smaller
        10
        sums
        777770
        IFNZRO ROTATE <
        sumt            / turn to the left, to the right
        777777
        sumt
        1
        >

/ Viewing parameters: first values from the scene tape.
/ In: scene tape, scale0.
/ Out: ex ey ez scale; views and the sums are zero.
/ Destroys: nothing else.
initpr, 0
        IFNZRO WALK <
        dzm scene       / the cell is found when the first view begins
        >
        lac scene+2
        dac ex
        lac scene+3
        dac ey
        lac scene+4
        dac ez
        lac scale0
        dac scale
        IFNZRO ROTATE <
        lac angle0
        dac angle
        lac (100000     / half a unit
        dac remx
        dac remz
        dzm sumt
        >
        dzm sumx
        dzm sumy
        dzm sumz
        dzm sums
        dzm views
        jmp i initpr

/ Apply what the switches have summed up, within the box where the eye may be;
/ with WALK the sums are the steps that the walk takes.
/ In: ex ey ez scale, the sums, scene tape.
/ Out: ex ey ez scale, with WALK step instead of the eye; the sums are zero.
/ Destroys: limlo limhi limt.
newpar, 0
        iof
        IFZERO WALK <
        lac ex
        tad sumx
        dac ex
        lac ey
        tad sumy
        dac ey
        lac ez
        tad sumz
        dac ez
        >
        IFNZRO WALK <
        lac sumx
        dac step
        lac sumy
        dac step+1
        lac sumz
        dac step+2
        IFNZRO ROTATE <
        lac sumt
        dac step+3
        dzm sumt
        >
        >
        lac scale
        tad sums
        dac scale
        dzm sumx
        dzm sumy
        dzm sumz
        dzm sums
        ion
        IFZERO WALK <
        lac ex
        jms limitx
        dac ex
        lac scene+7
        dac limlo
        lac scene+10
        dac limhi
        lac ey
        jms limit
        dac ey
        lac scene+11
        dac limlo
        lac scene+12
        dac limhi
        lac ez
        jms limit
        dac ez
        >
        lac (100
        dac limlo
        lac (10000
        dac limhi
        lac scale
        jms limit
        dac scale
        jmp i newpar

/ In: AC, scene tape.  Out: AC.  Destroys: limlo limhi limt.
limitx, 0               / AC within the box's low x..high x
        dac limt
        lac scene+5
        dac limlo
        lac scene+6
        dac limhi
        lac limt
        jms limit
        jmp i limitx

/ In: AC, limlo, limhi.  Out: AC.  Destroys: limt.
limit,  0               / AC within limlo..limhi
        dac limt
        cma
        tad (1
        tad limlo       / lo - v
        spa
        jmp limhig
        lac limlo
        jmp i limit
limhig, lac limhi
        cma
        tad (1
        tad limt        / v - hi
        spa
        jmp limok
        lac limhi
        jmp i limit
limok,  lac limt
        jmp i limit

/ Windows.  wxlo.. are units from the centre, half points with one fraction
/ bit; cx2 is the centre plus half a point, for rounding.
/ In: ex, scale.  Out: pex pjw wxlo wxhi cx2.  Destroys: nothing else.
monwin, 0
        lac scale
        IFNZRO FRACTION <
        rcl
        >
        IFNZRO FRACTION&2 <
        rcl
        >
        IFZERO FRACTION-3 <
        rcl
        >
        dac pjw
        lac ex
        dac pex
        IFNZRO ROTATE <
        lac ez
        dac pez
        >
        lac (-u1000+1   / -512 points
        dac wxlo
        lac (u1000-unit / 511
        dac wxhi
        lac (u1000+uhalf
        dac cx2
        jmp i monwin

/ In: ex, eyesep, scale, scene tape.
/ Out: pex pjw wxlo wxhi cx2.
/ Destroys: limlo limhi limt.
lefwin, 0
        jms halfw
        lac eyesep
        cma
        tad (1
        IFZERO ROTATE <
        tad ex
        jms limitx
        dac pex
        >
        IFNZRO ROTATE <
        jms beside
        >
        lac (u400+uhalf
        dac cx2
        jmp i lefwin

/ In: as lefwin.  Out: as lefwin.  Destroys: as lefwin.
rigwin, 0
        jms halfw
        lac eyesep
        IFZERO ROTATE <
        tad ex
        jms limitx
        dac pex
        >
        IFNZRO ROTATE <
        jms beside
        >
        lac (u1000+u400+uhalf
        dac cx2
        jmp i rigwin

/ In: scale.  Out: pjw wxlo wxhi.  Destroys: nothing else.
halfw,  0
        lac scale
        rcr
        IFNZRO FRACTION <
        rcl
        >
        IFNZRO FRACTION&2 <
        rcl
        >
        IFZERO FRACTION-3 <
        rcl
        >
        dac pjw
        lac (-u400+1    / -256 points
        dac wxlo
        lac (u400-unit  / 255
        dac wxhi
        jmp i halfw

eyesep, 5               / half the distance between the eyes of a pair
scale0, 1000            / scale of the first view: 90 degrees
        IFNZRO ROTATE <
angle0,  0               / direction of the first view: degrees to the right of +z
        >

/ Variables of this tape
file,   0               / the current display file; the handler starts it
shown,  0               / the file the display was last started with
runing, 0               / nonzero once the display runs
mode,   0               / 1 stereo pair, 2 lines added at once
status, 0
views,  0               / views complete
ex,     0               / viewing parameters
ey,     0
ez,     0
scale,  0
pex,    0               / eye x of this pass
        IFNZRO ROTATE <
pez,    0               / and z
sumt,   0
        >
sumx,   0               / what the switches have asked for
sumy,   0
sumz,   0
sums,   0
wxlo,   0
wxhi,   0
cx2,    0
limlo,  0
limhi,  0
limt,   0
intac,  0
intpt,  0
tksw,   0
tkn,    0
tkcell, 0
tkstep, 0
