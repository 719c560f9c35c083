/ Type 340, mode 4: one vector word, 100 steps to the right, at four scales. Look at the gaps: a step lights one point only.
100/
begin,  law file
        idla
        idsi
        jmp .-1
        hlt

file,   020117          / scale 0 (steps of 1 point), intensity 7, point words follow
        220500          / Y = 500, a point word follows
        100200          / X = 200, vector words follow
        600100          / 100 to the right, lit; escape: a parameter word follows
        020120          / scale 1 (steps of 2 points)
        220440
        100200
        600100
        020140          / scale 2 (steps of 4)
        220400
        100200
        600100
        020160          / scale 3 (steps of 8)
        220340
        100200
        600100
        003000

        start begin
