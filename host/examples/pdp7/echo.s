/ Teletype: types each key that is pressed, to the first carriage return. Look at KRB: it reads the key and puts its flag down.
100/
begin,  ksf             / skip if a key has come
        jmp .-1
        krb             / the key into AC, with 200 added: channel 8 is always marked
        tls             / type it; the printer takes its seven low bits
        tsf             / wait until it is typed
        jmp .-1
        sad (215        / skip if it was not a carriage return
        hlt
        jmp begin

        start begin
