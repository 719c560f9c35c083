/ scene street4: 26 cells in 376 words, 76 openings in 796, header 11
scene,  c0                  / initial cell
        000032              / number of cells 26
        000045              / eye x 37
        000240              / eye y 160
        000024              / eye z 20
        776341              / eye: lowest x -799
        001437              / eye: highest x 799
        000001              / eye: lowest y 1
        001273              / eye: highest y 699
        000013              / eye: lowest z 11
        000617              / eye: highest z 399
c0,     776340              / cell 0: origin x -800
        000000              / cell 0: origin y 0
        000012              / cell 0: origin z 10
        000015              / vectors 13
        503100              / real i +1600
        601274              / real j +700
        574700              / real i -1600
        676504              / real j -700
        700606              / real k +390
        100454              / dummy i +300
        500454              / real i +300
        101750              / dummy i +1000
        777172              / real k -390
        201274              / dummy j +700
        700606              / real k +390
        174700              / dummy i -1600
        777172              / real k -390
        o0+1                / to cell 1
        o1+1                / to cell 2
        400000+o2+1         / to cell 3
c1,     776340              / cell 1: origin x -800
        000000              / cell 1: origin y 0
        005670              / cell 1: origin z 3000
        000021              / vectors 17
        500454              / real i +300
        201274              / dummy j +700
        577324              / real i -300
        676504              / real j -700
        772730              / real k -2600
        201274              / dummy j +700
        705050              / real k +2600
        100454              / dummy i +300
        276504              / dummy j -700
        372730              / dummy k -2600
        700454              / real k +300
        300310              / dummy k +200
        700454              / real k +300
        300310              / dummy k +200
        700454              / real k +300
        300310              / dummy k +200
        700454              / real k +300
        o0                  / to cell 0
        o3+1                / to cell 3
        o4+1                / to cell 7
        o5+1                / to cell 9
        o6+1                / to cell 11
        o7+1                / to cell 13
        o8+1                / to cell 15
        o9+1                / to cell 17
        400000+o10+1        / to cell 19
c2,     000310              / cell 2: origin x 200
        000000              / cell 2: origin y 0
        000702              / cell 2: origin z 450
        000007              / vectors 7
        500454              / real i +300
        176504              / dummy i -700
        777716              / real k -50
        101750              / dummy i +1000
        700062              / real k +50
        201274              / dummy j +700
        777716              / real k -50
        o1                  / to cell 0
        o11+1               / to cell 4
        o12+1               / to cell 5
        o13+1               / to cell 6
        400000+o14          / to cell 3
c3,     777014              / cell 3: origin x -500
        000372              / cell 3: origin y 250
        000620              / cell 3: origin z 400
        000000              / vectors 0
        o2                  / to cell 0
        o3                  / to cell 1
        o14+1               / to cell 2
        o15+1               / to cell 4
        o16+1               / to cell 9
        400000+o29          / to cell 7
c4,     777470              / cell 4: origin x -200
        000000              / cell 4: origin y 0
        004540              / cell 4: origin z 2400
        000024              / vectors 20
        500120              / real i +80
        100360              / dummy i +240
        500120              / real i +80
        374142              / dummy k -1950
        700454              / real k +300
        300310              / dummy k +200
        700454              / real k +300
        300310              / dummy k +200
        700454              / real k +300
        300310              / dummy k +200
        700454              / real k +300
        177160              / dummy i -400
        374370              / dummy k -1800
        700372              / real k +250
        300310              / dummy k +200
        700454              / real k +300
        300310              / dummy k +200
        700454              / real k +300
        300310              / dummy k +200
        700454              / real k +300
        o11                 / to cell 2
        o15                 / to cell 3
        o17+1               / to cell 6
        o18+1               / to cell 8
        o19+1               / to cell 10
        o20+1               / to cell 12
        o21+1               / to cell 14
        o22+1               / to cell 16
        o23+1               / to cell 18
        o24+1               / to cell 20
        o25+1               / to cell 21
        o26+1               / to cell 22
        o30                 / to cell 7
        o34                 / to cell 9
        o38                 / to cell 11
        o43                 / to cell 13
        o48                 / to cell 15
        o54                 / to cell 17
        400000+o59          / to cell 19
c5,     000764              / cell 5: origin x 500
        000000              / cell 5: origin y 0
        005670              / cell 5: origin z 3000
        000020              / vectors 16
        500454              / real i +300
        601274              / real j +700
        577324              / real i -300
        100454              / dummy i +300
        773012              / real k -2550
        276504              / dummy j -700
        704766              / real k +2550
        177324              / dummy i -300
        373012              / dummy k -2550
        700454              / real k +300
        300310              / dummy k +200
        700454              / real k +300
        300310              / dummy k +200
        700454              / real k +300
        300310              / dummy k +200
        700454              / real k +300
        o12                 / to cell 2
        o27                 / to cell 6
        o31                 / to cell 8
        o36                 / to cell 10
        o41                 / to cell 12
        o47                 / to cell 14
        o51                 / to cell 16
        o57                 / to cell 18
        400000+o62          / to cell 20
c6,     000310              / cell 6: origin x 200
        000466              / cell 6: origin y 310
        000702              / cell 6: origin z 450
        000000              / vectors 0
        o13                 / to cell 2
        o17                 / to cell 4
        o27+1               / to cell 5
        o28+1               / to cell 14
        o32                 / to cell 8
        400000+o37          / to cell 10
c7,     777014              / cell 7: origin x -500
        000000              / cell 7: origin y 0
        001274              / cell 7: origin z 700
        000003              / vectors 3
        500454              / real i +300
        300310              / dummy k +200
        577324              / real i -300
        o4                  / to cell 1
        o29+1               / to cell 3
        400000+o30+1        / to cell 4
c8,     000310              / cell 8: origin x 200
        000000              / cell 8: origin y 0
        001356              / cell 8: origin z 750
        000003              / vectors 3
        500454              / real i +300
        300310              / dummy k +200
        577324              / real i -300
        o18                 / to cell 4
        o31+1               / to cell 5
        o32+1               / to cell 6
        400000+o33+1        / to cell 10
c9,     777014              / cell 9: origin x -500
        001274              / cell 9: origin y 700
        005670              / cell 9: origin z 3000
        000001              / vectors 1
        500454              / real i +300
        o5                  / to cell 1
        o16                 / to cell 3
        o34+1               / to cell 4
        o35+1               / to cell 22
        o39                 / to cell 11
        400000+o44          / to cell 13
c10,    000310              / cell 10: origin x 200
        000360              / cell 10: origin y 240
        001666              / cell 10: origin z 950
        000000              / vectors 0
        o19                 / to cell 4
        o33                 / to cell 8
        o36+1               / to cell 5
        o37+1               / to cell 6
        400000+o42          / to cell 12
c11,    777014              / cell 11: origin x -500
        000000              / cell 11: origin y 0
        002260              / cell 11: origin z 1200
        000003              / vectors 3
        500454              / real i +300
        300310              / dummy k +200
        577324              / real i -300
        o6                  / to cell 1
        o38+1               / to cell 4
        o39+1               / to cell 9
        400000+o40+1        / to cell 13
c12,    000310              / cell 12: origin x 200
        000000              / cell 12: origin y 0
        002342              / cell 12: origin z 1250
        000003              / vectors 3
        500454              / real i +300
        300310              / dummy k +200
        577324              / real i -300
        o20                 / to cell 4
        o41+1               / to cell 5
        400000+o42+1        / to cell 10
c13,    777014              / cell 13: origin x -500
        000466              / cell 13: origin y 310
        002570              / cell 13: origin z 1400
        000000              / vectors 0
        o7                  / to cell 1
        o40                 / to cell 11
        o43+1               / to cell 4
        o44+1               / to cell 9
        o45+1               / to cell 22
        o46+1               / to cell 23
        o49                 / to cell 15
        400000+o55          / to cell 17
c14,    000310              / cell 14: origin x 200
        001274              / cell 14: origin y 700
        005670              / cell 14: origin z 3000
        000001              / vectors 1
        500454              / real i +300
        o21                 / to cell 4
        o28                 / to cell 6
        o47+1               / to cell 5
        o52                 / to cell 16
        o58                 / to cell 18
        400000+o66          / to cell 22
c15,    777014              / cell 15: origin x -500
        000000              / cell 15: origin y 0
        003244              / cell 15: origin z 1700
        000003              / vectors 3
        500454              / real i +300
        300310              / dummy k +200
        577324              / real i -300
        o8                  / to cell 1
        o48+1               / to cell 4
        o49+1               / to cell 13
        400000+o50+1        / to cell 17
c16,    000310              / cell 16: origin x 200
        000000              / cell 16: origin y 0
        003326              / cell 16: origin z 1750
        000003              / vectors 3
        500454              / real i +300
        300310              / dummy k +200
        577324              / real i -300
        o22                 / to cell 4
        o51+1               / to cell 5
        o52+1               / to cell 14
        400000+o53+1        / to cell 18
c17,    777014              / cell 17: origin x -500
        000372              / cell 17: origin y 250
        003554              / cell 17: origin z 1900
        000000              / vectors 0
        o9                  / to cell 1
        o50                 / to cell 15
        o54+1               / to cell 4
        o55+1               / to cell 13
        o56+1               / to cell 23
        400000+o60          / to cell 19
c18,    000310              / cell 18: origin x 200
        000574              / cell 18: origin y 380
        003636              / cell 18: origin z 1950
        000000              / vectors 0
        o23                 / to cell 4
        o53                 / to cell 16
        o57+1               / to cell 5
        o58+1               / to cell 14
        o63                 / to cell 20
        400000+o67          / to cell 22
c19,    777014              / cell 19: origin x -500
        000000              / cell 19: origin y 0
        005670              / cell 19: origin z 3000
        000006              / vectors 6
        500454              / real i +300
        376340              / dummy k -800
        577324              / real i -300
        100454              / dummy i +300
        300310              / dummy k +200
        700120              / real k +80
        o10                 / to cell 1
        o59+1               / to cell 4
        o60+1               / to cell 17
        400000+o61+1        / to cell 23
c20,    000310              / cell 20: origin x 200
        000000              / cell 20: origin y 0
        005670              / cell 20: origin z 3000
        000005              / vectors 5
        500454              / real i +300
        376422              / dummy k -750
        577324              / real i -300
        300226              / dummy k +150
        700120              / real k +80
        o24                 / to cell 4
        o62+1               / to cell 5
        o63+1               / to cell 18
        o68                 / to cell 22
        400000+o72          / to cell 24
c21,    777610              / cell 21: origin x -120
        000000              / cell 21: origin y 0
        005670              / cell 21: origin z 3000
        000011              / vectors 9
        500360              / real i +240
        376650              / dummy k -600
        700120              / real k +80
        177420              / dummy i -240
        777660              / real k -80
        200404              / dummy j +260
        700120              / real k +80
        100360              / dummy i +240
        777660              / real k -80
        o25                 / to cell 4
        o64+1               / to cell 24
        o65+1               / to cell 25
        400000+o69          / to cell 23
c22,    777470              / cell 22: origin x -200
        001274              / cell 22: origin y 700
        005670              / cell 22: origin z 3000
        000001              / vectors 1
        500620              / real i +400
        o26                 / to cell 4
        o35                 / to cell 9
        o45                 / to cell 13
        o66+1               / to cell 14
        o67+1               / to cell 18
        o68+1               / to cell 20
        o70                 / to cell 23
        o73                 / to cell 24
        400000+o74          / to cell 25
c23,    777470              / cell 23: origin x -200
        000000              / cell 23: origin y 0
        005670              / cell 23: origin z 3000
        000003              / vectors 3
        500120              / real i +80
        376770              / dummy k -520
        577660              / real i -80
        o46                 / to cell 13
        o56                 / to cell 17
        o61                 / to cell 19
        o69+1               / to cell 21
        o70+1               / to cell 22
        400000+o71+1        / to cell 25
c24,    000170              / cell 24: origin x 120
        000000              / cell 24: origin y 0
        005670              / cell 24: origin z 3000
        000003              / vectors 3
        500120              / real i +80
        376770              / dummy k -520
        577660              / real i -80
        o64                 / to cell 21
        o72+1               / to cell 20
        o73+1               / to cell 22
        400000+o75          / to cell 25
c25,    777610              / cell 25: origin x -120
        000404              / cell 25: origin y 260
        004660              / cell 25: origin z 2480
        000000              / vectors 0
        o65                 / to cell 21
        o71                 / to cell 23
        o74+1               / to cell 22
        400000+o75+1        / to cell 24
o0,     400000+c0           / opening 0: cell on the low side
        c1                  / cell on the high side
        776340              / opening 0: origin x -800
        000000              / opening 0: origin y 0
        000620              / opening 0: origin z 400
        000005              / vectors 5
        100454              / dummy i +300
        600372              / real j +250
        200702              / dummy j +450
        177324              / dummy i -300
        276504              / dummy j -700
o1,     400000+c0           / opening 1: cell on the low side
        c2                  / cell on the high side
        777470              / opening 1: origin x -200
        000000              / opening 1: origin y 0
        000620              / opening 1: origin z 400
        000005              / vectors 5
        101750              / dummy i +1000
        201274              / dummy j +700
        176030              / dummy i -1000
        277076              / dummy j -450
        677406              / real j -250
o2,     400000+c0           / opening 2: cell on the low side
        c3                  / cell on the high side
        777014              / opening 2: origin x -500
        000372              / opening 2: origin y 250
        000620              / opening 2: origin z 400
        000004              / vectors 4
        500454              / real i +300
        200702              / dummy j +450
        177324              / dummy i -300
        277076              / dummy j -450
o3,     400000+c1           / opening 3: cell on the low side
        c3                  / cell on the high side
        777014              / opening 3: origin x -500
        000372              / opening 3: origin y 250
        000620              / opening 3: origin z 400
        000006              / vectors 6
        200702              / dummy j +450
        300764              / dummy k +500
        277266              / dummy j -330
        677610              / real j -120
        377470              / dummy k -200
        777324              / real k -300
o4,     400000+c1           / opening 4: cell on the low side
        c7                  / cell on the high side
        777014              / opening 4: origin x -500
        000000              / opening 4: origin y 0
        001274              / opening 4: origin z 700
        000004              / vectors 4
        600372              / real j +250
        300310              / dummy k +200
        677406              / real j -250
        377470              / dummy k -200
o5,     400000+c1           / opening 5: cell on the low side
        c9                  / cell on the high side
        777014              / opening 5: origin x -500
        000562              / opening 5: origin y 370
        001604              / opening 5: origin z 900
        000005              / vectors 5
        200512              / dummy j +330
        304064              / dummy k +2100
        277266              / dummy j -330
        374370              / dummy k -1800
        777324              / real k -300
o6,     400000+c1           / opening 6: cell on the low side
        c11                 / cell on the high side
        777014              / opening 6: origin x -500
        000000              / opening 6: origin y 0
        002260              / opening 6: origin z 1200
        000005              / vectors 5
        600562              / real j +370
        300310              / dummy k +200
        277704              / dummy j -60
        677312              / real j -310
        377470              / dummy k -200
o7,     400000+c1           / opening 7: cell on the low side
        c13                 / cell on the high side
        777014              / opening 7: origin x -500
        000466              / opening 7: origin y 310
        002570              / opening 7: origin z 1400
        000005              / vectors 5
        200074              / dummy j +60
        303100              / dummy k +1600
        277704              / dummy j -60
        375354              / dummy k -1300
        777324              / real k -300
o8,     400000+c1           / opening 8: cell on the low side
        c15                 / cell on the high side
        777014              / opening 8: origin x -500
        000000              / opening 8: origin y 0
        003244              / opening 8: origin z 1700
        000005              / vectors 5
        600466              / real j +310
        300310              / dummy k +200
        277704              / dummy j -60
        677406              / real j -250
        377470              / dummy k -200
o9,     400000+c1           / opening 9: cell on the low side
        c17                 / cell on the high side
        777014              / opening 9: origin x -500
        000372              / opening 9: origin y 250
        003554              / opening 9: origin z 1900
        000005              / vectors 5
        200074              / dummy j +60
        302114              / dummy k +1100
        277704              / dummy j -60
        376340              / dummy k -800
        777324              / real k -300
o10,    400000+c1           / opening 10: cell on the low side
        c19                 / cell on the high side
        777014              / opening 10: origin x -500
        000000              / opening 10: origin y 0
        004230              / opening 10: origin z 2200
        000004              / vectors 4
        600372              / real j +250
        301440              / dummy k +800
        277406              / dummy j -250
        376340              / dummy k -800
o11,    400000+c2           / opening 11: cell on the low side
        c4                  / cell on the high side
        777470              / opening 11: origin x -200
        000000              / opening 11: origin y 0
        000702              / opening 11: origin z 450
        000005              / vectors 5
        100620              / dummy i +400
        600466              / real j +310
        200606              / dummy j +390
        177160              / dummy i -400
        276504              / dummy j -700
o12,    400000+c2           / opening 12: cell on the low side
        c5                  / cell on the high side
        000764              / opening 12: origin x 500
        000000              / opening 12: origin y 0
        000702              / opening 12: origin z 450
        000005              / vectors 5
        100454              / dummy i +300
        201274              / dummy j +700
        177324              / dummy i -300
        277172              / dummy j -390
        677312              / real j -310
o13,    400000+c2           / opening 13: cell on the low side
        c6                  / cell on the high side
        000310              / opening 13: origin x 200
        000466              / opening 13: origin y 310
        000702              / opening 13: origin z 450
        000004              / vectors 4
        500454              / real i +300
        200606              / dummy j +390
        177324              / dummy i -300
        277172              / dummy j -390
o14,    400000+c3           / opening 14: cell on the low side
        c2                  / cell on the high side
        777470              / opening 14: origin x -200
        000372              / opening 14: origin y 250
        000620              / opening 14: origin z 400
        000004              / vectors 4
        200702              / dummy j +450
        300062              / dummy k +50
        277076              / dummy j -450
        777716              / real k -50
o15,    400000+c3           / opening 15: cell on the low side
        c4                  / cell on the high side
        777470              / opening 15: origin x -200
        000372              / opening 15: origin y 250
        000702              / opening 15: origin z 450
        000006              / vectors 6
        200702              / dummy j +450
        300702              / dummy k +450
        277266              / dummy j -330
        677610              / real j -120
        377470              / dummy k -200
        777406              / real k -250
o16,    400000+c3           / opening 16: cell on the low side
        c9                  / cell on the high side
        777014              / opening 16: origin x -500
        000562              / opening 16: origin y 370
        001604              / opening 16: origin z 900
        000004              / vectors 4
        500454              / real i +300
        200512              / dummy j +330
        177324              / dummy i -300
        277266              / dummy j -330
o17,    400000+c4           / opening 17: cell on the low side
        c6                  / cell on the high side
        000310              / opening 17: origin x 200
        000466              / opening 17: origin y 310
        000702              / opening 17: origin z 450
        000006              / vectors 6
        200606              / dummy j +390
        301750              / dummy k +1000
        277406              / dummy j -250
        677564              / real j -140
        376504              / dummy k -700
        777324              / real k -300
o18,    400000+c4           / opening 18: cell on the low side
        c8                  / cell on the high side
        000310              / opening 18: origin x 200
        000000              / opening 18: origin y 0
        001356              / opening 18: origin z 750
        000005              / vectors 5
        600466              / real j +310
        300310              / dummy k +200
        277672              / dummy j -70
        677420              / real j -240
        377470              / dummy k -200
o19,    400000+c4           / opening 19: cell on the low side
        c10                 / cell on the high side
        000310              / opening 19: origin x 200
        000360              / opening 19: origin y 240
        001666              / opening 19: origin z 950
        000005              / vectors 5
        200106              / dummy j +70
        300764              / dummy k +500
        677672              / real j -70
        377470              / dummy k -200
        777324              / real k -300
o20,    400000+c4           / opening 20: cell on the low side
        c12                 / cell on the high side
        000310              / opening 20: origin x 200
        000000              / opening 20: origin y 0
        002342              / opening 20: origin z 1250
        000004              / vectors 4
        600360              / real j +240
        300310              / dummy k +200
        677420              / real j -240
        377470              / dummy k -200
o21,    400000+c4           / opening 21: cell on the low side
        c14                 / cell on the high side
        000310              / opening 21: origin x 200
        000702              / opening 21: origin y 450
        002652              / opening 21: origin z 1450
        000005              / vectors 5
        200372              / dummy j +250
        301666              / dummy k +950
        277406              / dummy j -250
        376566              / dummy k -650
        777324              / real k -300
o22,    400000+c4           / opening 22: cell on the low side
        c16                 / cell on the high side
        000310              / opening 22: origin x 200
        000000              / opening 22: origin y 0
        003326              / opening 22: origin z 1750
        000005              / vectors 5
        600702              / real j +450
        300310              / dummy k +200
        277672              / dummy j -70
        677204              / real j -380
        377470              / dummy k -200
o23,    400000+c4           / opening 23: cell on the low side
        c18                 / cell on the high side
        000310              / opening 23: origin x 200
        000574              / opening 23: origin y 380
        003636              / opening 23: origin z 1950
        000005              / vectors 5
        200106              / dummy j +70
        300702              / dummy k +450
        277672              / dummy j -70
        377552              / dummy k -150
        777324              / real k -300
o24,    400000+c4           / opening 24: cell on the low side
        c20                 / cell on the high side
        000310              / opening 24: origin x 200
        000000              / opening 24: origin y 0
        004312              / opening 24: origin z 2250
        000005              / vectors 5
        600574              / real j +380
        300226              / dummy k +150
        277730              / dummy j -40
        677254              / real j -340
        377552              / dummy k -150
o25,    400000+c4           / opening 25: cell on the low side
        c21                 / cell on the high side
        777610              / opening 25: origin x -120
        000000              / opening 25: origin y 0
        004540              / opening 25: origin z 2400
        000004              / vectors 4
        100360              / dummy i +240
        600404              / real j +260
        577420              / real i -240
        677374              / real j -260
o26,    400000+c4           / opening 26: cell on the low side
        c22                 / cell on the high side
        777470              / opening 26: origin x -200
        000524              / opening 26: origin y 340
        004540              / opening 26: origin z 2400
        000004              / vectors 4
        500620              / real i +400
        200550              / dummy j +360
        177160              / dummy i -400
        277230              / dummy j -360
o27,    400000+c6           / opening 27: cell on the low side
        c5                  / cell on the high side
        000764              / opening 27: origin x 500
        000466              / opening 27: origin y 310
        000702              / opening 27: origin z 450
        000006              / vectors 6
        200606              / dummy j +390
        301750              / dummy k +1000
        277406              / dummy j -250
        677564              / real j -140
        376504              / dummy k -700
        777324              / real k -300
o28,    400000+c6           / opening 28: cell on the low side
        c14                 / cell on the high side
        000310              / opening 28: origin x 200
        000702              / opening 28: origin y 450
        002652              / opening 28: origin z 1450
        000004              / vectors 4
        500454              / real i +300
        200372              / dummy j +250
        177324              / dummy i -300
        277406              / dummy j -250
o29,    400000+c7           / opening 29: cell on the low side
        c3                  / cell on the high side
        777014              / opening 29: origin x -500
        000372              / opening 29: origin y 250
        001274              / opening 29: origin z 700
        000004              / vectors 4
        500454              / real i +300
        300310              / dummy k +200
        177324              / dummy i -300
        377470              / dummy k -200
o30,    400000+c7           / opening 30: cell on the low side
        c4                  / cell on the high side
        777470              / opening 30: origin x -200
        000000              / opening 30: origin y 0
        001274              / opening 30: origin z 700
        000004              / vectors 4
        600372              / real j +250
        300310              / dummy k +200
        677406              / real j -250
        377470              / dummy k -200
o31,    400000+c8           / opening 31: cell on the low side
        c5                  / cell on the high side
        000764              / opening 31: origin x 500
        000000              / opening 31: origin y 0
        001356              / opening 31: origin z 750
        000005              / vectors 5
        600466              / real j +310
        300310              / dummy k +200
        277672              / dummy j -70
        677420              / real j -240
        377470              / dummy k -200
o32,    400000+c8           / opening 32: cell on the low side
        c6                  / cell on the high side
        000310              / opening 32: origin x 200
        000466              / opening 32: origin y 310
        001356              / opening 32: origin z 750
        000004              / vectors 4
        500454              / real i +300
        300310              / dummy k +200
        177324              / dummy i -300
        377470              / dummy k -200
o33,    400000+c8           / opening 33: cell on the low side
        c10                 / cell on the high side
        000310              / opening 33: origin x 200
        000360              / opening 33: origin y 240
        001666              / opening 33: origin z 950
        000004              / vectors 4
        500454              / real i +300
        200106              / dummy j +70
        177324              / dummy i -300
        277672              / dummy j -70
o34,    400000+c9           / opening 34: cell on the low side
        c4                  / cell on the high side
        777470              / opening 34: origin x -200
        000562              / opening 34: origin y 370
        001604              / opening 34: origin z 900
        000005              / vectors 5
        200512              / dummy j +330
        302734              / dummy k +1500
        277266              / dummy j -330
        375520              / dummy k -1200
        777324              / real k -300
o35,    400000+c9           / opening 35: cell on the low side
        c22                 / cell on the high side
        777470              / opening 35: origin x -200
        000562              / opening 35: origin y 370
        004540              / opening 35: origin z 2400
        000004              / vectors 4
        200512              / dummy j +330
        301130              / dummy k +600
        277266              / dummy j -330
        376650              / dummy k -600
o36,    400000+c10          / opening 36: cell on the low side
        c5                  / cell on the high side
        000764              / opening 36: origin x 500
        000360              / opening 36: origin y 240
        001666              / opening 36: origin z 950
        000005              / vectors 5
        200106              / dummy j +70
        300764              / dummy k +500
        677672              / real j -70
        377470              / dummy k -200
        777324              / real k -300
o37,    400000+c10          / opening 37: cell on the low side
        c6                  / cell on the high side
        000310              / opening 37: origin x 200
        000466              / opening 37: origin y 310
        001666              / opening 37: origin z 950
        000004              / vectors 4
        100454              / dummy i +300
        300764              / dummy k +500
        177324              / dummy i -300
        377014              / dummy k -500
o38,    400000+c11          / opening 38: cell on the low side
        c4                  / cell on the high side
        777470              / opening 38: origin x -200
        000000              / opening 38: origin y 0
        002260              / opening 38: origin z 1200
        000005              / vectors 5
        600562              / real j +370
        300310              / dummy k +200
        277704              / dummy j -60
        677312              / real j -310
        377470              / dummy k -200
o39,    400000+c11          / opening 39: cell on the low side
        c9                  / cell on the high side
        777014              / opening 39: origin x -500
        000562              / opening 39: origin y 370
        002260              / opening 39: origin z 1200
        000004              / vectors 4
        500454              / real i +300
        300310              / dummy k +200
        177324              / dummy i -300
        377470              / dummy k -200
o40,    400000+c11          / opening 40: cell on the low side
        c13                 / cell on the high side
        777014              / opening 40: origin x -500
        000466              / opening 40: origin y 310
        002570              / opening 40: origin z 1400
        000004              / vectors 4
        500454              / real i +300
        200074              / dummy j +60
        177324              / dummy i -300
        277704              / dummy j -60
o41,    400000+c12          / opening 41: cell on the low side
        c5                  / cell on the high side
        000764              / opening 41: origin x 500
        000000              / opening 41: origin y 0
        002342              / opening 41: origin z 1250
        000004              / vectors 4
        600360              / real j +240
        300310              / dummy k +200
        677420              / real j -240
        377470              / dummy k -200
o42,    400000+c12          / opening 42: cell on the low side
        c10                 / cell on the high side
        000310              / opening 42: origin x 200
        000360              / opening 42: origin y 240
        002342              / opening 42: origin z 1250
        000004              / vectors 4
        500454              / real i +300
        300310              / dummy k +200
        177324              / dummy i -300
        377470              / dummy k -200
o43,    400000+c13          / opening 43: cell on the low side
        c4                  / cell on the high side
        777470              / opening 43: origin x -200
        000466              / opening 43: origin y 310
        002570              / opening 43: origin z 1400
        000006              / vectors 6
        200074              / dummy j +60
        301750              / dummy k +1000
        277742              / dummy j -30
        677742              / real j -30
        376504              / dummy k -700
        777324              / real k -300
o44,    400000+c13          / opening 44: cell on the low side
        c9                  / cell on the high side
        777014              / opening 44: origin x -500
        000562              / opening 44: origin y 370
        002570              / opening 44: origin z 1400
        000004              / vectors 4
        100454              / dummy i +300
        303100              / dummy k +1600
        177324              / dummy i -300
        374700              / dummy k -1600
o45,    400000+c13          / opening 45: cell on the low side
        c22                 / cell on the high side
        777470              / opening 45: origin x -200
        000524              / opening 45: origin y 340
        004540              / opening 45: origin z 2400
        000005              / vectors 5
        200036              / dummy j +30
        301130              / dummy k +600
        277742              / dummy j -30
        376770              / dummy k -520
        777660              / real k -80
o46,    400000+c13          / opening 46: cell on the low side
        c23                 / cell on the high side
        777470              / opening 46: origin x -200
        000466              / opening 46: origin y 310
        004660              / opening 46: origin z 2480
        000004              / vectors 4
        600036              / real j +30
        301010              / dummy k +520
        277742              / dummy j -30
        376770              / dummy k -520
o47,    400000+c14          / opening 47: cell on the low side
        c5                  / cell on the high side
        000764              / opening 47: origin x 500
        000702              / opening 47: origin y 450
        002652              / opening 47: origin z 1450
        000005              / vectors 5
        200372              / dummy j +250
        303016              / dummy k +1550
        277406              / dummy j -250
        375436              / dummy k -1250
        777324              / real k -300
o48,    400000+c15          / opening 48: cell on the low side
        c4                  / cell on the high side
        777470              / opening 48: origin x -200
        000000              / opening 48: origin y 0
        003244              / opening 48: origin z 1700
        000005              / vectors 5
        600466              / real j +310
        300310              / dummy k +200
        277704              / dummy j -60
        677406              / real j -250
        377470              / dummy k -200
o49,    400000+c15          / opening 49: cell on the low side
        c13                 / cell on the high side
        777014              / opening 49: origin x -500
        000466              / opening 49: origin y 310
        003244              / opening 49: origin z 1700
        000004              / vectors 4
        500454              / real i +300
        300310              / dummy k +200
        177324              / dummy i -300
        377470              / dummy k -200
o50,    400000+c15          / opening 50: cell on the low side
        c17                 / cell on the high side
        777014              / opening 50: origin x -500
        000372              / opening 50: origin y 250
        003554              / opening 50: origin z 1900
        000004              / vectors 4
        500454              / real i +300
        200074              / dummy j +60
        177324              / dummy i -300
        277704              / dummy j -60
o51,    400000+c16          / opening 51: cell on the low side
        c5                  / cell on the high side
        000764              / opening 51: origin x 500
        000000              / opening 51: origin y 0
        003326              / opening 51: origin z 1750
        000005              / vectors 5
        600702              / real j +450
        300310              / dummy k +200
        277672              / dummy j -70
        677204              / real j -380
        377470              / dummy k -200
o52,    400000+c16          / opening 52: cell on the low side
        c14                 / cell on the high side
        000310              / opening 52: origin x 200
        000702              / opening 52: origin y 450
        003326              / opening 52: origin z 1750
        000004              / vectors 4
        500454              / real i +300
        300310              / dummy k +200
        177324              / dummy i -300
        377470              / dummy k -200
o53,    400000+c16          / opening 53: cell on the low side
        c18                 / cell on the high side
        000310              / opening 53: origin x 200
        000574              / opening 53: origin y 380
        003636              / opening 53: origin z 1950
        000004              / vectors 4
        500454              / real i +300
        200106              / dummy j +70
        177324              / dummy i -300
        277672              / dummy j -70
o54,    400000+c17          / opening 54: cell on the low side
        c4                  / cell on the high side
        777470              / opening 54: origin x -200
        000372              / opening 54: origin y 250
        003554              / opening 54: origin z 1900
        000005              / vectors 5
        200074              / dummy j +60
        300764              / dummy k +500
        677704              / real j -60
        377470              / dummy k -200
        777324              / real k -300
o55,    400000+c17          / opening 55: cell on the low side
        c13                 / cell on the high side
        777014              / opening 55: origin x -500
        000466              / opening 55: origin y 310
        003554              / opening 55: origin z 1900
        000004              / vectors 4
        100454              / dummy i +300
        302114              / dummy k +1100
        177324              / dummy i -300
        375664              / dummy k -1100
o56,    400000+c17          / opening 56: cell on the low side
        c23                 / cell on the high side
        777470              / opening 56: origin x -200
        000372              / opening 56: origin y 250
        004660              / opening 56: origin z 2480
        000004              / vectors 4
        600074              / real j +60
        301010              / dummy k +520
        277704              / dummy j -60
        376770              / dummy k -520
o57,    400000+c18          / opening 57: cell on the low side
        c5                  / cell on the high side
        000764              / opening 57: origin x 500
        000574              / opening 57: origin y 380
        003636              / opening 57: origin z 1950
        000005              / vectors 5
        200106              / dummy j +70
        302032              / dummy k +1050
        277672              / dummy j -70
        376422              / dummy k -750
        777324              / real k -300
o58,    400000+c18          / opening 58: cell on the low side
        c14                 / cell on the high side
        000310              / opening 58: origin x 200
        000702              / opening 58: origin y 450
        003636              / opening 58: origin z 1950
        000004              / vectors 4
        100454              / dummy i +300
        302032              / dummy k +1050
        177324              / dummy i -300
        375746              / dummy k -1050
o59,    400000+c19          / opening 59: cell on the low side
        c4                  / cell on the high side
        777470              / opening 59: origin x -200
        000000              / opening 59: origin y 0
        004230              / opening 59: origin z 2200
        000004              / vectors 4
        600372              / real j +250
        300310              / dummy k +200
        677406              / real j -250
        377470              / dummy k -200
o60,    400000+c19          / opening 60: cell on the low side
        c17                 / cell on the high side
        777014              / opening 60: origin x -500
        000372              / opening 60: origin y 250
        004230              / opening 60: origin z 2200
        000004              / vectors 4
        500454              / real i +300
        301440              / dummy k +800
        177324              / dummy i -300
        376340              / dummy k -800
o61,    400000+c19          / opening 61: cell on the low side
        c23                 / cell on the high side
        777470              / opening 61: origin x -200
        000000              / opening 61: origin y 0
        004660              / opening 61: origin z 2480
        000004              / vectors 4
        600372              / real j +250
        301010              / dummy k +520
        277406              / dummy j -250
        376770              / dummy k -520
o62,    400000+c20          / opening 62: cell on the low side
        c5                  / cell on the high side
        000764              / opening 62: origin x 500
        000000              / opening 62: origin y 0
        004312              / opening 62: origin z 2250
        000004              / vectors 4
        600574              / real j +380
        301356              / dummy k +750
        277204              / dummy j -380
        376422              / dummy k -750
o63,    400000+c20          / opening 63: cell on the low side
        c18                 / cell on the high side
        000310              / opening 63: origin x 200
        000574              / opening 63: origin y 380
        004312              / opening 63: origin z 2250
        000004              / vectors 4
        500454              / real i +300
        301356              / dummy k +750
        177324              / dummy i -300
        376422              / dummy k -750
o64,    400000+c21          / opening 64: cell on the low side
        c24                 / cell on the high side
        000170              / opening 64: origin x 120
        000000              / opening 64: origin y 0
        004660              / opening 64: origin z 2480
        000004              / vectors 4
        600404              / real j +260
        301010              / dummy k +520
        277374              / dummy j -260
        376770              / dummy k -520
o65,    400000+c21          / opening 65: cell on the low side
        c25                 / cell on the high side
        777610              / opening 65: origin x -120
        000404              / opening 65: origin y 260
        004660              / opening 65: origin z 2480
        000004              / vectors 4
        500360              / real i +240
        301010              / dummy k +520
        177420              / dummy i -240
        376770              / dummy k -520
o66,    400000+c22          / opening 66: cell on the low side
        c14                 / cell on the high side
        000310              / opening 66: origin x 200
        000702              / opening 66: origin y 450
        004540              / opening 66: origin z 2400
        000004              / vectors 4
        200372              / dummy j +250
        301130              / dummy k +600
        277406              / dummy j -250
        376650              / dummy k -600
o67,    400000+c22          / opening 67: cell on the low side
        c18                 / cell on the high side
        000310              / opening 67: origin x 200
        000574              / opening 67: origin y 380
        004540              / opening 67: origin z 2400
        000004              / vectors 4
        200106              / dummy j +70
        301130              / dummy k +600
        277672              / dummy j -70
        376650              / dummy k -600
o68,    400000+c22          / opening 68: cell on the low side
        c20                 / cell on the high side
        000310              / opening 68: origin x 200
        000524              / opening 68: origin y 340
        004540              / opening 68: origin z 2400
        000005              / vectors 5
        200050              / dummy j +40
        301130              / dummy k +600
        277730              / dummy j -40
        376770              / dummy k -520
        777660              / real k -80
o69,    400000+c23          / opening 69: cell on the low side
        c21                 / cell on the high side
        777610              / opening 69: origin x -120
        000000              / opening 69: origin y 0
        004660              / opening 69: origin z 2480
        000004              / vectors 4
        600404              / real j +260
        301010              / dummy k +520
        277374              / dummy j -260
        376770              / dummy k -520
o70,    400000+c23          / opening 70: cell on the low side
        c22                 / cell on the high side
        777470              / opening 70: origin x -200
        000524              / opening 70: origin y 340
        004660              / opening 70: origin z 2480
        000004              / vectors 4
        500120              / real i +80
        301010              / dummy k +520
        177660              / dummy i -80
        376770              / dummy k -520
o71,    400000+c23          / opening 71: cell on the low side
        c25                 / cell on the high side
        777610              / opening 71: origin x -120
        000404              / opening 71: origin y 260
        004660              / opening 71: origin z 2480
        000004              / vectors 4
        200120              / dummy j +80
        301010              / dummy k +520
        277660              / dummy j -80
        376770              / dummy k -520
o72,    400000+c24          / opening 72: cell on the low side
        c20                 / cell on the high side
        000310              / opening 72: origin x 200
        000000              / opening 72: origin y 0
        004660              / opening 72: origin z 2480
        000004              / vectors 4
        600524              / real j +340
        301010              / dummy k +520
        277254              / dummy j -340
        376770              / dummy k -520
o73,    400000+c24          / opening 73: cell on the low side
        c22                 / cell on the high side
        000170              / opening 73: origin x 120
        000524              / opening 73: origin y 340
        004660              / opening 73: origin z 2480
        000004              / vectors 4
        500120              / real i +80
        301010              / dummy k +520
        177660              / dummy i -80
        376770              / dummy k -520
o74,    400000+c25          / opening 74: cell on the low side
        c22                 / cell on the high side
        777610              / opening 74: origin x -120
        000524              / opening 74: origin y 340
        004660              / opening 74: origin z 2480
        000004              / vectors 4
        500360              / real i +240
        301010              / dummy k +520
        177420              / dummy i -240
        376770              / dummy k -520
o75,    400000+c25          / opening 75: cell on the low side
        c24                 / cell on the high side
        000170              / opening 75: origin x 120
        000404              / opening 75: origin y 260
        004660              / opening 75: origin z 2480
        000004              / vectors 4
        200120              / dummy j +80
        301010              / dummy k +520
        277660              / dummy j -80
        376770              / dummy k -520
