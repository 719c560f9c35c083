/ The read-in-mode loader of an 8K PDP-7 (P4-65 has the 4K version), started at 17770.
17762/
r,      0
        rsf
        jmp .-1
        rrb
        rsb
        jmp i r
go,     rsb
g,      jms r
        dac out
        xct out
        jms r
out,    0
        jmp g
        start go
