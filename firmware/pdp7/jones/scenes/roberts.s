/ scene roberts: 12 cells in 153 words, 30 openings in 313, header 11
scene,  c1                  / initial cell
        000014              / number of cells 12
        000036              / eye x 30
        000226              / eye y 150
        000050              / eye z 40
        777161              / eye: lowest x -399
        000617              / eye: highest x 399
        777635              / eye: lowest y -99
        000453              / eye: highest y 299
        000013              / eye: lowest z 11
        001127              / eye: highest z 599
c0,     777160              / cell 0: origin x -400
        777324              / cell 0: origin y -300
        000012              / cell 0: origin z 10
        000013              / vectors 11
        501440              / real i +800
        600310              / real j +200
        176340              / dummy i -800
        677470              / real j -200
        703066              / real k +1590
        501440              / real i +800
        600310              / real j +200
        176340              / dummy i -800
        677470              / real j -200
        101440              / dummy i +800
        774712              / real k -1590
        o0+1                / to cell 1
        o1+1                / to cell 2
        o2+1                / to cell 3
        400000+o3+1         / to cell 9
c1,     777160              / cell 1: origin x -400
        000454              / cell 1: origin y 300
        000012              / cell 1: origin z 10
        000007              / vectors 7
        501440              / real i +800
        677160              / real j -400
        176340              / dummy i -800
        600620              / real j +400
        701116              / real k +590
        101440              / dummy i +800
        776662              / real k -590
        o0                  / to cell 0
        o4+1                / to cell 2
        o5+1                / to cell 3
        o6+1                / to cell 4
        400000+o7+1         / to cell 5
c2,     777160              / cell 2: origin x -400
        000454              / cell 2: origin y 300
        003100              / cell 2: origin z 1600
        000005              / vectors 5
        500430              / real i +280
        177350              / dummy i -280
        677160              / real j -400
        200620              / dummy j +400
        776030              / real k -1000
        o1                  / to cell 0
        o4                  / to cell 1
        o8+1                / to cell 5
        o9+1                / to cell 9
        400000+o10+1        / to cell 10
c3,     000170              / cell 3: origin x 120
        000454              / cell 3: origin y 300
        003100              / cell 3: origin z 1600
        000004              / vectors 4
        500430              / real i +280
        677160              / real j -400
        200620              / dummy j +400
        776030              / real k -1000
        o2                  / to cell 0
        o5                  / to cell 1
        o11                 / to cell 4
        o19                 / to cell 7
        o22                 / to cell 9
        400000+o28          / to cell 11
c4,     000062              / cell 4: origin x 50
        777754              / cell 4: origin y -20
        001200              / cell 4: origin z 640
        000003              / vectors 3
        500106              / real i +70
        177526              / dummy i -170
        777730              / real k -40
        o6                  / to cell 1
        o11+1               / to cell 3
        o12+1               / to cell 6
        o13+1               / to cell 7
        400000+o14          / to cell 5
c5,     777610              / cell 5: origin x -120
        000454              / cell 5: origin y 300
        003100              / cell 5: origin z 1600
        000001              / vectors 1
        500106              / real i +70
        o7                  / to cell 1
        o8                  / to cell 2
        o14+1               / to cell 4
        o15+1               / to cell 6
        o16+1               / to cell 8
        400000+o26          / to cell 10
c6,     777716              / cell 6: origin x -50
        777754              / cell 6: origin y -20
        001274              / cell 6: origin z 700
        000007              / vectors 7
        500144              / real i +100
        600050              / real j +40
        177634              / dummy i -100
        677730              / real j -40
        777704              / real k -60
        100144              / dummy i +100
        700074              / real k +60
        o12                 / to cell 4
        o15                 / to cell 5
        o17+1               / to cell 7
        400000+o18+1        / to cell 8
c7,     000062              / cell 7: origin x 50
        000454              / cell 7: origin y 300
        003100              / cell 7: origin z 1600
        000001              / vectors 1
        500106              / real i +70
        o13                 / to cell 4
        o17                 / to cell 6
        o19+1               / to cell 3
        o20                 / to cell 8
        400000+o29          / to cell 11
c8,     777716              / cell 8: origin x -50
        000454              / cell 8: origin y 300
        003100              / cell 8: origin z 1600
        000006              / vectors 6
        500144              / real i +100
        277350              / dummy j -280
        376174              / dummy k -900
        700144              / real k +100
        177634              / dummy i -100
        777634              / real k -100
        o16                 / to cell 5
        o18                 / to cell 6
        o20+1               / to cell 7
        o21+1               / to cell 11
        o23                 / to cell 9
        400000+o27          / to cell 10
c9,     777610              / cell 9: origin x -120
        777634              / cell 9: origin y -100
        001440              / cell 9: origin z 800
        000000              / vectors 0
        o3                  / to cell 0
        o9                  / to cell 2
        o22+1               / to cell 3
        o23+1               / to cell 8
        o24+1               / to cell 10
        400000+o25+1        / to cell 11
c10,    777610              / cell 10: origin x -120
        000024              / cell 10: origin y 20
        001440              / cell 10: origin z 800
        000000              / vectors 0
        o10                 / to cell 2
        o24                 / to cell 9
        o26+1               / to cell 5
        400000+o27+1        / to cell 8
c11,    000062              / cell 11: origin x 50
        000024              / cell 11: origin y 20
        001440              / cell 11: origin z 800
        000000              / vectors 0
        o21                 / to cell 8
        o25                 / to cell 9
        o28+1               / to cell 3
        400000+o29+1        / to cell 7
o0,     400000+c0           / opening 0: cell on the low side
        c1                  / cell on the high side
        777160              / opening 0: origin x -400
        777634              / opening 0: origin y -100
        000012              / opening 0: origin z 10
        000006              / vectors 6
        101440              / dummy i +800
        301116              / dummy k +590
        177350              / dummy i -280
        577420              / real i -240
        177350              / dummy i -280
        376662              / dummy k -590
o1,     400000+c0           / opening 1: cell on the low side
        c2                  / cell on the high side
        777160              / opening 1: origin x -400
        777634              / opening 1: origin y -100
        001130              / opening 1: origin z 600
        000005              / vectors 5
        100430              / dummy i +280
        700310              / real k +200
        301440              / dummy k +800
        177350              / dummy i -280
        376030              / dummy k -1000
o2,     400000+c0           / opening 2: cell on the low side
        c3                  / cell on the high side
        000170              / opening 2: origin x 120
        777634              / opening 2: origin y -100
        001130              / opening 2: origin z 600
        000005              / vectors 5
        100430              / dummy i +280
        301750              / dummy k +1000
        177350              / dummy i -280
        376340              / dummy k -800
        777470              / real k -200
o3,     400000+c0           / opening 3: cell on the low side
        c9                  / cell on the high side
        777610              / opening 3: origin x -120
        777634              / opening 3: origin y -100
        001440              / opening 3: origin z 800
        000004              / vectors 4
        500360              / real i +240
        301440              / dummy k +800
        177420              / dummy i -240
        376340              / dummy k -800
o4,     400000+c1           / opening 4: cell on the low side
        c2                  / cell on the high side
        777160              / opening 4: origin x -400
        777634              / opening 4: origin y -100
        001130              / opening 4: origin z 600
        000005              / vectors 5
        100430              / dummy i +280
        600240              / real j +160
        200360              / dummy j +240
        177350              / dummy i -280
        277160              / dummy j -400
o5,     400000+c1           / opening 5: cell on the low side
        c3                  / cell on the high side
        000170              / opening 5: origin x 120
        777634              / opening 5: origin y -100
        001130              / opening 5: origin z 600
        000005              / vectors 5
        100430              / dummy i +280
        200620              / dummy j +400
        177350              / dummy i -280
        277300              / dummy j -320
        677660              / real j -80
o6,     400000+c1           / opening 6: cell on the low side
        c4                  / cell on the high side
        777716              / opening 6: origin x -50
        777754              / opening 6: origin y -20
        001130              / opening 6: origin z 600
        000005              / vectors 5
        500252              / real i +170
        200500              / dummy j +320
        177526              / dummy i -170
        277420              / dummy j -240
        677660              / real j -80
o7,     400000+c1           / opening 7: cell on the low side
        c5                  / cell on the high side
        777610              / opening 7: origin x -120
        000074              / opening 7: origin y 60
        001130              / opening 7: origin z 600
        000004              / vectors 4
        500106              / real i +70
        200360              / dummy j +240
        177672              / dummy i -70
        277420              / dummy j -240
o8,     400000+c2           / opening 8: cell on the low side
        c5                  / cell on the high side
        777610              / opening 8: origin x -120
        000074              / opening 8: origin y 60
        001130              / opening 8: origin z 600
        000005              / vectors 5
        200360              / dummy j +240
        301750              / dummy k +1000
        277420              / dummy j -240
        376340              / dummy k -800
        777470              / real k -200
o9,     400000+c2           / opening 9: cell on the low side
        c9                  / cell on the high side
        777610              / opening 9: origin x -120
        777634              / opening 9: origin y -100
        001440              / opening 9: origin z 800
        000004              / vectors 4
        600170              / real j +120
        301440              / dummy k +800
        277610              / dummy j -120
        376340              / dummy k -800
o10,    400000+c2           / opening 10: cell on the low side
        c10                 / cell on the high side
        777610              / opening 10: origin x -120
        000024              / opening 10: origin y 20
        001440              / opening 10: origin z 800
        000004              / vectors 4
        600050              / real j +40
        301440              / dummy k +800
        277730              / dummy j -40
        376340              / dummy k -800
o11,    400000+c4           / opening 11: cell on the low side
        c3                  / cell on the high side
        000170              / opening 11: origin x 120
        777754              / opening 11: origin y -20
        001130              / opening 11: origin z 600
        000005              / vectors 5
        200500              / dummy j +320
        300050              / dummy k +40
        277420              / dummy j -240
        677660              / real j -80
        777730              / real k -40
o12,    400000+c4           / opening 12: cell on the low side
        c6                  / cell on the high side
        777716              / opening 12: origin x -50
        777754              / opening 12: origin y -20
        001200              / opening 12: origin z 640
        000005              / vectors 5
        100144              / dummy i +100
        600120              / real j +80
        200360              / dummy j +240
        177634              / dummy i -100
        277300              / dummy j -320
o13,    400000+c4           / opening 13: cell on the low side
        c7                  / cell on the high side
        000062              / opening 13: origin x 50
        000074              / opening 13: origin y 60
        001200              / opening 13: origin z 640
        000004              / vectors 4
        500106              / real i +70
        200360              / dummy j +240
        177672              / dummy i -70
        277420              / dummy j -240
o14,    400000+c5           / opening 14: cell on the low side
        c4                  / cell on the high side
        777716              / opening 14: origin x -50
        000074              / opening 14: origin y 60
        001130              / opening 14: origin z 600
        000004              / vectors 4
        200360              / dummy j +240
        300050              / dummy k +40
        277420              / dummy j -240
        777730              / real k -40
o15,    400000+c5           / opening 15: cell on the low side
        c6                  / cell on the high side
        777716              / opening 15: origin x -50
        000074              / opening 15: origin y 60
        001200              / opening 15: origin z 640
        000004              / vectors 4
        200360              / dummy j +240
        300074              / dummy k +60
        277420              / dummy j -240
        777704              / real k -60
o16,    400000+c5           / opening 16: cell on the low side
        c8                  / cell on the high side
        777716              / opening 16: origin x -50
        000074              / opening 16: origin y 60
        001274              / opening 16: origin z 700
        000005              / vectors 5
        200360              / dummy j +240
        301604              / dummy k +900
        277420              / dummy j -240
        376340              / dummy k -800
        777634              / real k -100
o17,    400000+c6           / opening 17: cell on the low side
        c7                  / cell on the high side
        000062              / opening 17: origin x 50
        000074              / opening 17: origin y 60
        001200              / opening 17: origin z 640
        000004              / vectors 4
        200360              / dummy j +240
        300074              / dummy k +60
        277420              / dummy j -240
        777704              / real k -60
o18,    400000+c6           / opening 18: cell on the low side
        c8                  / cell on the high side
        777716              / opening 18: origin x -50
        000024              / opening 18: origin y 20
        001274              / opening 18: origin z 700
        000004              / vectors 4
        500144              / real i +100
        200430              / dummy j +280
        177634              / dummy i -100
        277350              / dummy j -280
o19,    400000+c7           / opening 19: cell on the low side
        c3                  / cell on the high side
        000170              / opening 19: origin x 120
        000074              / opening 19: origin y 60
        001200              / opening 19: origin z 640
        000005              / vectors 5
        200360              / dummy j +240
        301700              / dummy k +960
        277420              / dummy j -240
        376340              / dummy k -800
        777540              / real k -160
o20,    400000+c8           / opening 20: cell on the low side
        c7                  / cell on the high side
        000062              / opening 20: origin x 50
        000074              / opening 20: origin y 60
        001274              / opening 20: origin z 700
        000005              / vectors 5
        200360              / dummy j +240
        301604              / dummy k +900
        277420              / dummy j -240
        376340              / dummy k -800
        777634              / real k -100
o21,    400000+c8           / opening 21: cell on the low side
        c11                 / cell on the high side
        000062              / opening 21: origin x 50
        000024              / opening 21: origin y 20
        001440              / opening 21: origin z 800
        000004              / vectors 4
        600050              / real j +40
        301440              / dummy k +800
        277730              / dummy j -40
        376340              / dummy k -800
o22,    400000+c9           / opening 22: cell on the low side
        c3                  / cell on the high side
        000170              / opening 22: origin x 120
        777634              / opening 22: origin y -100
        001440              / opening 22: origin z 800
        000004              / vectors 4
        600170              / real j +120
        301440              / dummy k +800
        277610              / dummy j -120
        376340              / dummy k -800
o23,    400000+c9           / opening 23: cell on the low side
        c8                  / cell on the high side
        777716              / opening 23: origin x -50
        000024              / opening 23: origin y 20
        001440              / opening 23: origin z 800
        000004              / vectors 4
        500144              / real i +100
        301440              / dummy k +800
        177634              / dummy i -100
        376340              / dummy k -800
o24,    400000+c9           / opening 24: cell on the low side
        c10                 / cell on the high side
        777610              / opening 24: origin x -120
        000024              / opening 24: origin y 20
        001440              / opening 24: origin z 800
        000004              / vectors 4
        100106              / dummy i +70
        301440              / dummy k +800
        177672              / dummy i -70
        376340              / dummy k -800
o25,    400000+c9           / opening 25: cell on the low side
        c11                 / cell on the high side
        000062              / opening 25: origin x 50
        000024              / opening 25: origin y 20
        001440              / opening 25: origin z 800
        000004              / vectors 4
        100106              / dummy i +70
        301440              / dummy k +800
        177672              / dummy i -70
        376340              / dummy k -800
o26,    400000+c10          / opening 26: cell on the low side
        c5                  / cell on the high side
        777610              / opening 26: origin x -120
        000074              / opening 26: origin y 60
        001440              / opening 26: origin z 800
        000004              / vectors 4
        500106              / real i +70
        301440              / dummy k +800
        177672              / dummy i -70
        376340              / dummy k -800
o27,    400000+c10          / opening 27: cell on the low side
        c8                  / cell on the high side
        777716              / opening 27: origin x -50
        000024              / opening 27: origin y 20
        001440              / opening 27: origin z 800
        000004              / vectors 4
        600050              / real j +40
        301440              / dummy k +800
        277730              / dummy j -40
        376340              / dummy k -800
o28,    400000+c11          / opening 28: cell on the low side
        c3                  / cell on the high side
        000170              / opening 28: origin x 120
        000024              / opening 28: origin y 20
        001440              / opening 28: origin z 800
        000004              / vectors 4
        600050              / real j +40
        301440              / dummy k +800
        277730              / dummy j -40
        376340              / dummy k -800
o29,    400000+c11          / opening 29: cell on the low side
        c7                  / cell on the high side
        000062              / opening 29: origin x 50
        000074              / opening 29: origin y 60
        001440              / opening 29: origin z 800
        000004              / vectors 4
        500106              / real i +70
        301440              / dummy k +800
        177672              / dummy i -70
        376340              / dummy k -800
