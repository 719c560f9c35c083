/ Edge flags: a vector runs over the right edge of the screen. Look at what is typed: H for the horizontal edge flag.
100/
begin,  law file
        idla
look,   idhe            / skip if X ran over
        jmp .+3
        lac (110        / H
        jmp type
        idve            / skip if Y ran over
        jmp .+3
        lac (126        / V
        jmp type
        idsi            / skip if the file came to its stop word
        jmp look
        lac (123        / S
type,   tls             / type the character in AC
        tsf             / wait until it is typed
        jmp .-1
        hlt

file,   020117
        220500          / Y = 500
        101740          / X = 1740, 37 from the edge; vector words follow
        200100          / 100 to the right: the display stops at the edge
        003000

        start begin
