/ A PDP-7 program: shows a square with one diagonal on the Type 340 display, once, and halts.
/ Look at the display file below: each word is one command to the display.
100/
begin,  law file        / address of the display file
        idla            / load the display's address register and start it
        idsi            / skip when the display has met the stop word
        jmp .-1
        hlt

file,   020137          / parameter word: scale 1 (x2), intensity 7; a point word follows
        220601          / Y = 601; another point word follows
        100601          / X = 601; vector words follow
        200177          / vector: 177 to the right
        277400          / vector: 177 up
        200377          / vector: 177 to the left
        377400          / vector: 177 down
        677577          / vector: 177 to the right and 177 up; a parameter word follows
        003000          / stop, and raise the stop flag

        start begin
