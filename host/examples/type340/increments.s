/ Type 340, increment words: an octagon of 32 moves, four to a word. Look at the words: each has one direction, four times.
100/
begin,  law file
        idla
        idsi
        jmp .-1
        hlt

file,   020177          / scale 3 (moves of 8 points), intensity 7; a point word follows
        220600          / Y = 600; a point word follows
        140760          / X = 760; increment words follow
        304210          / 10 10 10 10: right
        325252          / 12 12 12 12: right and up
        221042          / 02 02 02 02: up
        367356          / 16 16 16 16: left and up
        346314          / 14 14 14 14: left
        377777          / 17 17 17 17: left and down
        231463          / 03 03 03 03: down
        735673          / 13 13 13 13: right and down; escape
        003000

        start begin
