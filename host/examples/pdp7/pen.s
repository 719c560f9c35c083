/ Light pen: shows a row of points until the pen sees one. Look at the AC at the end: X/2 in the left half, Y/2 in the right.
100/
begin,  law file
        idla
look,   idsp            / skip if the light-pen flag is up: the display waits, its coordinates can be read
        jmp .+3
        idrc            / AC from X/2 and Y/2
        hlt
        idsi            / the end of the pass: start again
        jmp look
        jmp begin

file,   034117          / light pen on, scale 0, intensity 7; a point word follows
        220400          / Y = 400; a point word follows
        022400          / X = 400, lit; a point word follows
        022500
        022600
        022700
        023000
        002000          / X = 0, lit; a parameter word follows
        003000

        start begin
