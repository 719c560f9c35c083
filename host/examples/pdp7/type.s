/ Teletype: types a text with a subroutine. Look at the call: the text follows it, three characters to a word, 00 ends it.
100/
begin,  jms type
        text /READY./
        0
        lac (15         / carriage return
        jms out
        lac (12         / line feed
        jms out
        hlt

type,   0               / JMS stores L and PC here: the address of the text
next,   lac i type
        sna             / a word of 0 ends the text
        jmp end
        dac word
        lam -2          / AC = 777775: three characters
        dac count
char,   lac word        / the next six bits go round to the right end
        rtl; rtl; rtl
        dac word
        ral             / L belongs to the 19 bits that rotate
        and (77
        sna             / 00 fills up the last word
        jmp skip
        jms six
        jms out
skip,   isz count
        jmp char
        isz type        / the next word of the text
        jmp next
end,    isz type        / return behind the 0
        jmp i type

six,    0               / from trimmed ASCII to ASCII: 01-37 are 101-137
        dac save
        and (40
        sza
        jmp .+4
        lac save
        xor (100
        jmp i six
        lac save
        jmp i six

out,    0
        tls
        tsf
        jmp .-1
        jmp i out

word,   0
count,  0
save,   0

        start begin
