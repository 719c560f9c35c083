/ Paper tape: reads a line from the reader and punches it, for ever. Look at the copy: it is the tape, hole by hole.
100/
begin,  rsa             / start the reader: one line
        rsf             / wait for its flag
        jmp .-1
        rrb             / the line into AC; the flag falls
        pls             / punch it
        psf
        jmp .-1
        jmp begin

        start begin
