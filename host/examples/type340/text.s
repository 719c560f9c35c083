/ Type 340 with the Type 342, character words: six-bit codes, three to a word. Look at the second line: it is twice as large.
100/
begin,  law file
        idla
        idsi
        jmp .-1
        hlt

file,   020137          / scale 1, intensity 7; a point word follows
        220600
        060100          / X = 100; character words follow
        text /PDP-7 AND 340/
        370000          / 37: escape; a parameter word follows
        020140          / scale 2: characters twice as large
        220500
        060100
        text /TWICE/
        370000
        003000          / stop, and raise the stop flag

        start begin
