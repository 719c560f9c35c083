/ The PDP-7 assembler: each form once. Look at the listing beside it: literals are placed at the end, equal ones once.
count=5                 / a name for a value; `sightline asm pdp7 -D count=7` wins over this line
100/                    / the location of what follows
begin,  lac (count      / a literal: the address of a word with this value
        dac total#      / # makes an undefined name a variable
        lac i list      / i: indirect
        tad list+1      / an expression: + - ! (OR) & (AND), from left to right
        spa cla         / microinstructions side by side are ORed
        jmp .+2         / . is this location
        lac (count      / the same literal
        lam -2; dac total
        ifzero count-5 < lac (17 >
        hlt

list,   .+1
        decimal
        20; -1          / 24 and 777776: one's complement
        octal
        text /HELLO/
        start begin
