/ Type 340, mode 5: a word is repeated to the edge of the screen. Look at where the four lines end: no edge flag is left.
100/
begin,  law file
        idla
        idsi
        jmp .-1
        hlt

file,   020117          / scale 0, intensity 7, point words follow
        221000          / Y = 1000
        121000          / X = 1000, a vector-continue word follows
        200177          / to the right, to the edge; a parameter word follows by itself
        020000
        221000
        121000
        277400          / up
        020000
        221000
        121000
        240300          / 100 to the left, 100 up
        020000
        221000
        121000
        320050          / 50 to the right, 40 down
        003000

        start begin
