/ Type 340 with the Type 347: one diamond, called at three places. Look at "shape": its last word escapes, and so returns.
100/
begin,  law file
        idla
        idsi
        jmp .-1
        hlt

file,   020117          / scale 0, intensity 7; a point word follows
        220500
        160200          / X = 200; a subroutine word follows
        700000 shape    / jump to shape and save the return address; a vector word follows
        020000          / back here, in mode 0
        220540
        160400
        700000 shape
        020000
        220500
        160600
        700000 shape
        003000

shape,  220040          / 40 right and 40 up, lit
        220240          / 40 left and 40 up
        320240          / 40 left and 40 down
        720040          / 40 right and 40 down; escape: return to the word after the call

        start begin
