/ Type 340, point words: eight points in a row. Look at the brightness in the photograph: intensity 7 on the left, 0 on the right.
100/
begin,  law file
        idla
        idsi
        jmp .-1
        hlt

file,   020117          / parameter word: scale 0, intensity 7; a point word follows
        220500          / Y = 500, dark; a point word follows
        002400          / X = 400, lit; a parameter word follows
        020016
        002440
        020015
        002500
        020014
        002540
        020013
        002600
        020012
        002640
        020011
        002700
        020010
        002740
        003000          / stop, and raise the stop flag

        start begin
