/ A solid turning with hidden lines, for the PDP-7 and Type 340.   Tape 1: control
/
/ The on-line phase of Plantinga, Seales and Dyer (1990).  Four tapes, read one
/ after the other; assembled with EAE=1 or EAE=0 and EXTEND=0 (8K) or EXTEND=1
/ (32K).  What each part computes is in SPECIFICATION.md; which term of the paper
/ is which label here, and what each part costs, in NOTES.md.
/
/ Core:  00000-00021 interrupt, auto-index   00022- program   02500- the model
/ (20000- with 32K); the display files are where the model's tape says.
/ Auto-index registers: 10 tape, slots, code being made  11 two words of a place,
/ forms  12 places, junctions  13 changes of an event  14 display file.
/
/ Before each routine: what it takes (In), what it returns (Out), and what else
/ it writes (Destroys).  Not listed are AC, link and MQ, which every routine
/ destroys, and words that only the routine itself uses.

EXTEND=0
        IFZERO EXTEND <
model=2500
most=15300              / words up to the end of core
kind=401
        >
        IFNZRO EXTEND <
model=20000
most=60000
kind=402
        >

0/      0               / interrupt: L and PC
        jmp intr

22/
start,  caf
        IFNZRO EXTEND <
        eem
        >
        lac (4          / reading: what the word says if the tape ends early
        dac status
        jms rdword
        dac count
        spa sna
        jmp badtap
        cma
        tad (1
        dac n
        tad (most
        spa
        jmp badtap
        lac (model-1
        dac 10
rdnext, jms rdword
        dac i 10
        isz n
        jmp rdnext
        jms rdword
        dac chksum

/ The model is in core; a second start begins here.
begin,  iof
        IFNZRO EXTEND <
        eem
        >
        lac (model-1
        dac 10
        lac count
        spa sna
        jmp badtap
        cma
        tad (1
        dac n
        lac count
        tad chksum
sumnxt, tad i 10
        isz n
        jmp sumnxt
        sza
        jmp badsum
        lac (model
        dac slotp
        lac i slotp
        sad (kind
        skp
        jmp badtap
        dzm status
        dzm runing
        dzm frames
        dzm file
        dzm shown
        dzm bpep
        lac (model      / copy the header
        dac 10
        lac (header-1
        dac 11
        lac (hdrsiz
        cma
        tad (1
        dac n
cpynxt, lac i 10
        dac i 11
        isz n
        jmp cpynxt
        lac stangl
        dac angle
        dac at
        lac nfiles
        tad (777777
        dac fx
        ion
        las
        dac sw
        jmp pictur      / the first picture, at the model's angle

badsum, lac (1          / the sum is wrong
        skp
badtap, lac (3          / not a tape for this machine
        dac status
        hlt
        jmp .-1

/ Out: AC.  Destroys: nothing else.
rdword, 0               / one binary word from the reader
        rsb
        rsf
        jmp .-1
        rrb
        jmp i rdword

/ One picture after the other.
frame,  las
        dac sw
        and (100000
        sza
        jmp single
        lac sw
        and (77777
        dac step
        sza
        jmp move
        lac sw
        sad oldsw       / nothing moves
        jmp frame
move,   lac sw
        spa
        jmp moveba
        lac step
        jmp moved
moveba, lac step
        cma
        tad (1
moved,  tad angle
        dac angle

pictur, lac sw          / the picture's time begins here
        dac oldsw
        and (200000
        sza
        jmp wire
        jms turn
        lac sadwho
        dac wirsw
        lac nslots
        jmp pictgo
wire,   lac jmpfas      / every edge whole: the same loop without its question
        dac wirsw
        lac nedges
pictgo, dac slotn
        dzm status      / of this picture
        jms newfil
        jms sines
        jms places
        jms pieces
        jms endfil
        jms publsh
        jmp frame

/ Single event: at each rise of the switch, to the next event or before the last.
single, lac oldsw
        and (100000
        sza
        jmp singhd
        jms turn
        lac sw
        spa
        jmp singbk
        lac ep
        sad evend
        lac evbeg
        dac slotp
        lac i slotp
        dac angle
        jmp pictur
singbk, jms prevev
        lac i bp
        tad (777777
        dac angle
        jmp pictur
singhd, lac sw
        dac oldsw
        jmp frame

/ Bring the structure from the angle `at` to `angle` over the events between, the
/ shorter way.
/ In: at, angle, ep.
/ Out: at = angle, ep, the slots.
/ Destroys: 13 bp bpep slotp.
turn,   0
        lac at
        cma
        tad (1
        tad angle
        sna
        jmp i turn
        spa
        jmp back
        dac rem
forwev, lac ep
        sad evend
        lac evbeg
        dac ep
        lac at
        cma
        tad i ep        / how far the event is, less 1
        spa
        jmp turned
        cma
        tad rem
        spa
        jmp turned
        dac rem
        lac i ep
        dac at
        lac ep
        dac 13
        jms change
        lac 13
        tad (1
        dac ep
        jmp forwev
back,   cma
        tad (1
        dac rem
backev, jms prevev
        lac i bp
        cma
        tad (1
        tad at
        spa
        jmp turned
        cma
        tad rem
        spa
        jmp turned
        dac rem
        lac i bp
        tad (777777
        dac at
        lac bp
        dac ep
        dac 13
        jms change
        jmp backev
turned, lac angle
        dac at
        jmp i turn

/ In: ep, bpep.  Out: bp, bpep.  Destroys: nothing else.
prevev, 0               / bp = the angle of the event before ep
        lac ep
        sad bpep        / looked for before
        jmp i prevev
        dac bpep
        sad evbeg
        lac evend
        dac bp
prevlk, lac bp
        tad (777777
        dac bp
        lac i bp
        and (2
        sna
        jmp prevlk
        lac bp
        tad (777777
        dac bp
        jmp i prevev

/ The changes of one event, behind 13.  Each is an exclusive or, so that the same
/ words lead forwards and backwards.
/ In: 13 before the first change.
/ Out: 13 at the last change, the slots.
/ Destroys: slotp.
change, 0
chnext, lac i 13
        dac word
        and (3774
        tad slots
        dac slotp
        lac word
        and (4000
        sza
        jmp chsecd
        lac word
        and (770000
        jmp chxor
chsecd, lac word        / the second end: six places to the right
        rtr
        rtr
        rtr
        and (7700
chxor,  xor i slotp
        dac i slotp
        lac word
        rar
        snl
        jmp chnext
        jmp i change

/ Display files: 2 or 3, one after the other.
/ In: nfiles, files.  Out: dfs 14 room; lastv is 0.  Destroys: slotp.
newfil, 0
        lac nfiles
        sad (2          / of two, the other one may still be shown
        jms wait
        isz fx
        lac fx
        sad nfiles
        cla
        dac fx
        tad (files
        dac slotp
        lac i slotp
        dac dfs
        tad (777777
        dac 14
        tad filsiz      / room: the last word, less 14 for a piece and the stop
        tad (777763
        cma
        dac room
        lac (410117     / pen off, scale 0, intensity 7; endfil takes 400000 away
        dac i 14
        dzm lastv
        jmp i newfil

/ In: 14.  Out: 14.  Destroys: nothing else.
endfil, 0
        jms escape
        lac (3000       / stop, interrupt
        dac i 14
        jmp i endfil

/ In: 14.  Out: 14 is kept.  Destroys: nothing else.
escape, 0               / the last word written ends its vector, or is the first one
        lac 14
        dac lastp
        lac i lastp
        xor (400000
        dac i lastp
        jmp i escape

/ In: dfs.
/ Out: file = dfs, frames, and the display runs.
/ Destroys: nothing else.
publsh, 0
        lac nfiles
        sad (3          / of three, one may still wait to be shown
        jms wait
        isz frames
        nop
        lac dfs
        dac file        / the picture's time ends here
        lac runing
        sza
        jmp i publsh
        isz runing
        lac file
        dac shown
        idla
        jmp i publsh

/ In: file, shown.  Destroys: nothing else.
wait,   0               / until the display has taken up the last file
waitlp, lac shown
        sad file
waited, jmp i wait
        jmp waitlp

/ The display stopped, or something unwanted.
intr,   dac intac
        idsi
        jmp iother
        lac file
        dac shown
        idla
intrx,  lac 0
        ral             / the link as it was
        lac intac
        IFNZRO EXTEND <
        emir
        >
        ion
        jmp i 0
iother, idcf
        krb
        tcf
        pcf
        rcf
        jmp intrx

sadwho, sad whole
jmpfas, jmp fast

/ Variables of this tape
status, 0               / 0 right, 1 sum, 2 display file full, 3 other tape, 4 reading
count,  0               / words of the model
chksum, 0
n,      0
sw,     0
oldsw,  0
step,   0
angle,  0               / of this picture, 2^18 a turn
at,     0               / of the structure
rem,    0
bp,     0               / the event before that at bpep
bpep,   0
word,   0
slotp,  0
frames, 0
runing, 0
file,   0               / the current display file; the handler starts it
shown,  0               / the file the display was last started with
dfs,    0               / the file being made
fx,     0
room,   0
lastp,  0
intac,  0
slotn,  0
header=.                / words 1- of the model, in their order
nverts, 0               / less than 0, as the next counts
nslots, 0
nedges, 0
forms,  0               / addresses, those of these two less 1
placs,  0
slots,  0
evbeg,  0               / events: the first, behind the last, the next one
evend,  0
ep,     0
stangl, 0               / angle of the first picture
filsiz, 0               / words of a display file
nfiles, 0               / 2 or 3
files,  0               / their addresses
        0
        0
hdrsiz=.-header
