/ Type 340: a square that turns. Look at "turn": a circle without a multiplication, each coordinate moved by a part of the other.
100/
begin,  jms turn
        jms make
        lac (-30        / show it 24 times, then turn it on
        dac times
again,  law file
        idla
wait,   idsi            / skip when the display has come to its stop
        jmp wait
        isz times
        jmp again
        jmp begin

turn,   0               / x = x - y/64, then y = y + x/64
        lac y
        jms part
        cma
        tad (1
        tad x
        dac x
        lac x
        jms part
        tad y
        dac y
        jmp i turn

part,   0               / AC divided by 64, its sign kept
        spa
        jmp part1
        rcr
        jms five
        and (7777
        jmp i part
part1,  rcr
        jms five
        and (7777
        tad (770000
        jmp i part
five,   0
        rcr
        rcr
        rcr
        rcr
        rcr
        jmp i five

/ The side from (x, y) to the next corner is (x, y) itself, a quarter turn on for the next side: (-y, x), (-x, -y), (y, -x).
make,   0
        lac x
        dac a
        lac y
        dac b
        jms vector
        dac file+3
        lac y
        cma
        tad (1
        dac a
        lac x
        dac b
        jms vector
        dac file+4
        lac x
        cma
        tad (1
        dac a
        lac y
        cma
        tad (1
        dac b
        jms vector
        dac file+5
        lac y
        dac a
        lac x
        cma
        tad (1
        dac b
        jms vector
        xor (400000     / the last word escapes
        dac file+6
        jmp i make

/ A vector word from a and b: bit 1 lit, bit 2 down and 3-9 for y, bit 10 left and 11-17 for x; magnitudes of 7 bits.
vector, 0
        lac b
        jms size
        rcl
        rcl
        rcl
        rcl
        rcl
        rcl
        rcl
        rcl
        and (177400
        dac word
        lac a
        jms size
        xor word
        xor (200000
        jmp i vector
size,   0               / AC/512, as sign and magnitude: 0SMMMMMMM
        dac word1
        sma
        jmp .+3
        cma
        tad (1
        rcr
        jms five
        rcr
        rcr
        rcr
        and (177
        dac word2
        lac word1
        sma
        jmp .+4
        lac word2
        xor (200
        jmp i size
        lac word2
        jmp i size

times,  0
x,      144000          / 100 times 512, less than 127 times 512 ever
y,      0
a,      0
b,      0
word,   0
word1,  0
word2,  0

file,   020134          / scale 1, intensity 4; a point word follows
        221000          / Y = 512; a point word follows
        101000          / X = 512; a vector word follows
        0
        0
        0
        0
        003000          / stop, and an interrupt

        start begin
