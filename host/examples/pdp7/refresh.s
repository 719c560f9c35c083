/ Interrupts: the display is started again at each stop interrupt for one second of the clock. Look at how often: the AC at the end.
0/
        0               / an interrupt stores L and PC here and goes to 1
        jmp handle

7/
        -62+1           / the clock counts this word up: 62 ticks of 50 Hz are a second

100/
begin,  caf             / all flags down
        clon            / clock on
        law file
        idla            / the first start
        ion
wait,   lac done
        sna             / the clock's flag ends the wait
        jmp wait
        iof
        lac passes      / how many passes were shown
        hlt

handle, dac save        / the handler keeps AC; L is not changed by it
        clsf            / was it the clock?
        jmp stop
        clof            / its flag down and the clock off
        isz done
        jmp back
stop,   idsi            / was it the display's stop?
        jmp back        / no: nothing else is on
        isz passes
        law file
        idla            / the next pass; the stop flag falls
back,   lac save
        ion             / takes effect after the next instruction
        jmp i 0         / return

save,   0
done,   0
passes, 0

file,   020117          / scale 0, intensity 7; a point word follows
        220700
        100700          / X = 700; vector words follow
        200177          / to the right
        240000          / up
        200377          / to the left
        740000          / down; escape
        003000          / stop, and ask for an interrupt

        start begin
