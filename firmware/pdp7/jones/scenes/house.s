/ scene house: 3 cells in 71 words, 3 openings in 30, header 11
scene,  c0                  / initial cell
        000003              / number of cells 3
        000740              / eye x 480
        000240              / eye y 160
        000024              / eye z 20
        000001              / eye: lowest x 1
        001127              / eye: highest x 599
        000001              / eye: lowest y 1
        000371              / eye: highest y 249
        000001              / eye: lowest z 1
        000617              / eye: highest z 399
c0,     000000              / cell 0: origin x 0
        000000              / cell 0: origin y 0
        000000              / cell 0: origin z 0
        000023              / vectors 19
        501130              / real i +600
        600372              / real j +250
        576650              / real i -600
        677406              / real j -250
        700620              / real k +400
        500074              / real i +60
        100132              / dummy i +90
        500170              / real i +120
        100202              / dummy i +130
        500310              / real i +200
        600372              / real j +250
        576650              / real i -600
        677406              / real j -250
        200372              / dummy j +250
        777160              / real k -400
        101130              / dummy i +600
        700620              / real k +400
        277406              / dummy j -250
        777160              / real k -400
        o0+1                / to cell 1
        400000+o1+1         / to cell 2
c1,     000000              / cell 1: origin x 0
        000000              / cell 1: origin y 0
        000620              / cell 1: origin z 400
        000021              / vectors 17
        500074              / real i +60
        100132              / dummy i +90
        500144              / real i +100
        600372              / real j +250
        577406              / real i -250
        677406              / real j -250
        700536              / real k +350
        500372              / real i +250
        600372              / real j +250
        577406              / real i -250
        677406              / real j -250
        200372              / dummy j +250
        777242              / real k -350
        100372              / dummy i +250
        700536              / real k +350
        277406              / dummy j -250
        777242              / real k -350
        o0                  / to cell 0
        400000+o2+1         / to cell 2
c2,     000372              / cell 2: origin x 250
        000000              / cell 2: origin y 0
        001356              / cell 2: origin z 750
        000021              / vectors 17
        500536              / real i +350
        600372              / real j +250
        577242              / real i -350
        677406              / real j -250
        777242              / real k -350
        500024              / real i +20
        100202              / dummy i +130
        500310              / real i +200
        600372              / real j +250
        577242              / real i -350
        677406              / real j -250
        200372              / dummy j +250
        700536              / real k +350
        100536              / dummy i +350
        777242              / real k -350
        277406              / dummy j -250
        700536              / real k +350
        o1                  / to cell 0
        400000+o2           / to cell 1
o0,     400000+c0           / opening 0: cell on the low side
        c1                  / cell on the high side
        000074              / opening 0: origin x 60
        000000              / opening 0: origin y 0
        000620              / opening 0: origin z 400
        000004              / vectors 4
        100132              / dummy i +90
        600315              / real j +205
        577646              / real i -90
        677463              / real j -205
o1,     400000+c0           / opening 1: cell on the low side
        c2                  / cell on the high side
        000416              / opening 1: origin x 270
        000000              / opening 1: origin y 0
        000620              / opening 1: origin z 400
        000004              / vectors 4
        100202              / dummy i +130
        600315              / real j +205
        577576              / real i -130
        677463              / real j -205
o2,     400000+c1           / opening 2: cell on the low side
        c2                  / cell on the high side
        000372              / opening 2: origin x 250
        000132              / opening 2: origin y 90
        001060              / opening 2: origin z 560
        000004              / vectors 4
        600074              / real j +60
        700170              / real k +120
        677704              / real j -60
        777610              / real k -120
