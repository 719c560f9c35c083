/ scene corridor32: 32 cells in 794 words, 31 openings in 310, header 11
scene,  c0                  / initial cell
        000040              / number of cells 32
        000214              / eye x 140
        000226              / eye y 150
        000036              / eye z 30
        000001              / eye: lowest x 1
        000617              / eye: highest x 399
        000001              / eye: lowest y 1
        000453              / eye: highest y 299
        000001              / eye: lowest z 1
        000617              / eye: highest z 399
c0,     000000              / cell 0: origin x 0
        000000              / cell 0: origin y 0
        000000              / cell 0: origin z 0
        000021              / vectors 17
        500620              / real i +400
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        700620              / real k +400
        500202              / real i +130
        100156              / dummy i +110
        500240              / real i +160
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        200454              / dummy j +300
        777160              / real k -400
        100620              / dummy i +400
        700620              / real k +400
        277324              / dummy j -300
        777160              / real k -400
        400000+o0+1         / to cell 1
c1,     000000              / cell 1: origin x 0
        000000              / cell 1: origin y 0
        000620              / cell 1: origin z 400
        000023              / vectors 19
        500202              / real i +130
        100156              / dummy i +110
        500240              / real i +160
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        700620              / real k +400
        500106              / real i +70
        100156              / dummy i +110
        500334              / real i +220
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        200454              / dummy j +300
        777160              / real k -400
        100620              / dummy i +400
        700620              / real k +400
        277324              / dummy j -300
        777160              / real k -400
        o0                  / to cell 0
        400000+o1+1         / to cell 2
c2,     000000              / cell 2: origin x 0
        000000              / cell 2: origin y 0
        001440              / cell 2: origin z 800
        000023              / vectors 19
        500106              / real i +70
        100156              / dummy i +110
        500334              / real i +220
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        700620              / real k +400
        500240              / real i +160
        100156              / dummy i +110
        500202              / real i +130
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        200454              / dummy j +300
        777160              / real k -400
        100620              / dummy i +400
        700620              / real k +400
        277324              / dummy j -300
        777160              / real k -400
        o1                  / to cell 1
        400000+o2+1         / to cell 3
c3,     000000              / cell 3: origin x 0
        000000              / cell 3: origin y 0
        002260              / cell 3: origin z 1200
        000023              / vectors 19
        500240              / real i +160
        100156              / dummy i +110
        500202              / real i +130
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        700620              / real k +400
        500144              / real i +100
        100156              / dummy i +110
        500276              / real i +190
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        200454              / dummy j +300
        777160              / real k -400
        100620              / dummy i +400
        700620              / real k +400
        277324              / dummy j -300
        777160              / real k -400
        o2                  / to cell 2
        400000+o3+1         / to cell 4
c4,     000000              / cell 4: origin x 0
        000000              / cell 4: origin y 0
        003100              / cell 4: origin z 1600
        000023              / vectors 19
        500144              / real i +100
        100156              / dummy i +110
        500276              / real i +190
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        700620              / real k +400
        500050              / real i +40
        100156              / dummy i +110
        500372              / real i +250
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        200454              / dummy j +300
        777160              / real k -400
        100620              / dummy i +400
        700620              / real k +400
        277324              / dummy j -300
        777160              / real k -400
        o3                  / to cell 3
        400000+o4+1         / to cell 5
c5,     000000              / cell 5: origin x 0
        000000              / cell 5: origin y 0
        003720              / cell 5: origin z 2000
        000023              / vectors 19
        500050              / real i +40
        100156              / dummy i +110
        500372              / real i +250
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        700620              / real k +400
        500202              / real i +130
        100156              / dummy i +110
        500240              / real i +160
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        200454              / dummy j +300
        777160              / real k -400
        100620              / dummy i +400
        700620              / real k +400
        277324              / dummy j -300
        777160              / real k -400
        o4                  / to cell 4
        400000+o5+1         / to cell 6
c6,     000000              / cell 6: origin x 0
        000000              / cell 6: origin y 0
        004540              / cell 6: origin z 2400
        000023              / vectors 19
        500202              / real i +130
        100156              / dummy i +110
        500240              / real i +160
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        700620              / real k +400
        500106              / real i +70
        100156              / dummy i +110
        500334              / real i +220
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        200454              / dummy j +300
        777160              / real k -400
        100620              / dummy i +400
        700620              / real k +400
        277324              / dummy j -300
        777160              / real k -400
        o5                  / to cell 5
        400000+o6+1         / to cell 7
c7,     000000              / cell 7: origin x 0
        000000              / cell 7: origin y 0
        005360              / cell 7: origin z 2800
        000023              / vectors 19
        500106              / real i +70
        100156              / dummy i +110
        500334              / real i +220
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        700620              / real k +400
        500240              / real i +160
        100156              / dummy i +110
        500202              / real i +130
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        200454              / dummy j +300
        777160              / real k -400
        100620              / dummy i +400
        700620              / real k +400
        277324              / dummy j -300
        777160              / real k -400
        o6                  / to cell 6
        400000+o7+1         / to cell 8
c8,     000000              / cell 8: origin x 0
        000000              / cell 8: origin y 0
        006200              / cell 8: origin z 3200
        000023              / vectors 19
        500240              / real i +160
        100156              / dummy i +110
        500202              / real i +130
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        700620              / real k +400
        500144              / real i +100
        100156              / dummy i +110
        500276              / real i +190
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        200454              / dummy j +300
        777160              / real k -400
        100620              / dummy i +400
        700620              / real k +400
        277324              / dummy j -300
        777160              / real k -400
        o7                  / to cell 7
        400000+o8+1         / to cell 9
c9,     000000              / cell 9: origin x 0
        000000              / cell 9: origin y 0
        007020              / cell 9: origin z 3600
        000023              / vectors 19
        500144              / real i +100
        100156              / dummy i +110
        500276              / real i +190
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        700620              / real k +400
        500050              / real i +40
        100156              / dummy i +110
        500372              / real i +250
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        200454              / dummy j +300
        777160              / real k -400
        100620              / dummy i +400
        700620              / real k +400
        277324              / dummy j -300
        777160              / real k -400
        o8                  / to cell 8
        400000+o9+1         / to cell 10
c10,    000000              / cell 10: origin x 0
        000000              / cell 10: origin y 0
        007640              / cell 10: origin z 4000
        000023              / vectors 19
        500050              / real i +40
        100156              / dummy i +110
        500372              / real i +250
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        700620              / real k +400
        500202              / real i +130
        100156              / dummy i +110
        500240              / real i +160
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        200454              / dummy j +300
        777160              / real k -400
        100620              / dummy i +400
        700620              / real k +400
        277324              / dummy j -300
        777160              / real k -400
        o9                  / to cell 9
        400000+o10+1        / to cell 11
c11,    000000              / cell 11: origin x 0
        000000              / cell 11: origin y 0
        010460              / cell 11: origin z 4400
        000023              / vectors 19
        500202              / real i +130
        100156              / dummy i +110
        500240              / real i +160
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        700620              / real k +400
        500106              / real i +70
        100156              / dummy i +110
        500334              / real i +220
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        200454              / dummy j +300
        777160              / real k -400
        100620              / dummy i +400
        700620              / real k +400
        277324              / dummy j -300
        777160              / real k -400
        o10                 / to cell 10
        400000+o11+1        / to cell 12
c12,    000000              / cell 12: origin x 0
        000000              / cell 12: origin y 0
        011300              / cell 12: origin z 4800
        000023              / vectors 19
        500106              / real i +70
        100156              / dummy i +110
        500334              / real i +220
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        700620              / real k +400
        500240              / real i +160
        100156              / dummy i +110
        500202              / real i +130
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        200454              / dummy j +300
        777160              / real k -400
        100620              / dummy i +400
        700620              / real k +400
        277324              / dummy j -300
        777160              / real k -400
        o11                 / to cell 11
        400000+o12+1        / to cell 13
c13,    000000              / cell 13: origin x 0
        000000              / cell 13: origin y 0
        012120              / cell 13: origin z 5200
        000023              / vectors 19
        500240              / real i +160
        100156              / dummy i +110
        500202              / real i +130
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        700620              / real k +400
        500144              / real i +100
        100156              / dummy i +110
        500276              / real i +190
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        200454              / dummy j +300
        777160              / real k -400
        100620              / dummy i +400
        700620              / real k +400
        277324              / dummy j -300
        777160              / real k -400
        o12                 / to cell 12
        400000+o13+1        / to cell 14
c14,    000000              / cell 14: origin x 0
        000000              / cell 14: origin y 0
        012740              / cell 14: origin z 5600
        000023              / vectors 19
        500144              / real i +100
        100156              / dummy i +110
        500276              / real i +190
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        700620              / real k +400
        500050              / real i +40
        100156              / dummy i +110
        500372              / real i +250
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        200454              / dummy j +300
        777160              / real k -400
        100620              / dummy i +400
        700620              / real k +400
        277324              / dummy j -300
        777160              / real k -400
        o13                 / to cell 13
        400000+o14+1        / to cell 15
c15,    000000              / cell 15: origin x 0
        000000              / cell 15: origin y 0
        013560              / cell 15: origin z 6000
        000023              / vectors 19
        500050              / real i +40
        100156              / dummy i +110
        500372              / real i +250
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        700620              / real k +400
        500202              / real i +130
        100156              / dummy i +110
        500240              / real i +160
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        200454              / dummy j +300
        777160              / real k -400
        100620              / dummy i +400
        700620              / real k +400
        277324              / dummy j -300
        777160              / real k -400
        o14                 / to cell 14
        400000+o15+1        / to cell 16
c16,    000000              / cell 16: origin x 0
        000000              / cell 16: origin y 0
        014400              / cell 16: origin z 6400
        000023              / vectors 19
        500202              / real i +130
        100156              / dummy i +110
        500240              / real i +160
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        700620              / real k +400
        500106              / real i +70
        100156              / dummy i +110
        500334              / real i +220
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        200454              / dummy j +300
        777160              / real k -400
        100620              / dummy i +400
        700620              / real k +400
        277324              / dummy j -300
        777160              / real k -400
        o15                 / to cell 15
        400000+o16+1        / to cell 17
c17,    000000              / cell 17: origin x 0
        000000              / cell 17: origin y 0
        015220              / cell 17: origin z 6800
        000023              / vectors 19
        500106              / real i +70
        100156              / dummy i +110
        500334              / real i +220
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        700620              / real k +400
        500240              / real i +160
        100156              / dummy i +110
        500202              / real i +130
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        200454              / dummy j +300
        777160              / real k -400
        100620              / dummy i +400
        700620              / real k +400
        277324              / dummy j -300
        777160              / real k -400
        o16                 / to cell 16
        400000+o17+1        / to cell 18
c18,    000000              / cell 18: origin x 0
        000000              / cell 18: origin y 0
        016040              / cell 18: origin z 7200
        000023              / vectors 19
        500240              / real i +160
        100156              / dummy i +110
        500202              / real i +130
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        700620              / real k +400
        500144              / real i +100
        100156              / dummy i +110
        500276              / real i +190
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        200454              / dummy j +300
        777160              / real k -400
        100620              / dummy i +400
        700620              / real k +400
        277324              / dummy j -300
        777160              / real k -400
        o17                 / to cell 17
        400000+o18+1        / to cell 19
c19,    000000              / cell 19: origin x 0
        000000              / cell 19: origin y 0
        016660              / cell 19: origin z 7600
        000023              / vectors 19
        500144              / real i +100
        100156              / dummy i +110
        500276              / real i +190
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        700620              / real k +400
        500050              / real i +40
        100156              / dummy i +110
        500372              / real i +250
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        200454              / dummy j +300
        777160              / real k -400
        100620              / dummy i +400
        700620              / real k +400
        277324              / dummy j -300
        777160              / real k -400
        o18                 / to cell 18
        400000+o19+1        / to cell 20
c20,    000000              / cell 20: origin x 0
        000000              / cell 20: origin y 0
        017500              / cell 20: origin z 8000
        000023              / vectors 19
        500050              / real i +40
        100156              / dummy i +110
        500372              / real i +250
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        700620              / real k +400
        500202              / real i +130
        100156              / dummy i +110
        500240              / real i +160
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        200454              / dummy j +300
        777160              / real k -400
        100620              / dummy i +400
        700620              / real k +400
        277324              / dummy j -300
        777160              / real k -400
        o19                 / to cell 19
        400000+o20+1        / to cell 21
c21,    000000              / cell 21: origin x 0
        000000              / cell 21: origin y 0
        020320              / cell 21: origin z 8400
        000023              / vectors 19
        500202              / real i +130
        100156              / dummy i +110
        500240              / real i +160
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        700620              / real k +400
        500106              / real i +70
        100156              / dummy i +110
        500334              / real i +220
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        200454              / dummy j +300
        777160              / real k -400
        100620              / dummy i +400
        700620              / real k +400
        277324              / dummy j -300
        777160              / real k -400
        o20                 / to cell 20
        400000+o21+1        / to cell 22
c22,    000000              / cell 22: origin x 0
        000000              / cell 22: origin y 0
        021140              / cell 22: origin z 8800
        000023              / vectors 19
        500106              / real i +70
        100156              / dummy i +110
        500334              / real i +220
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        700620              / real k +400
        500240              / real i +160
        100156              / dummy i +110
        500202              / real i +130
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        200454              / dummy j +300
        777160              / real k -400
        100620              / dummy i +400
        700620              / real k +400
        277324              / dummy j -300
        777160              / real k -400
        o21                 / to cell 21
        400000+o22+1        / to cell 23
c23,    000000              / cell 23: origin x 0
        000000              / cell 23: origin y 0
        021760              / cell 23: origin z 9200
        000023              / vectors 19
        500240              / real i +160
        100156              / dummy i +110
        500202              / real i +130
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        700620              / real k +400
        500144              / real i +100
        100156              / dummy i +110
        500276              / real i +190
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        200454              / dummy j +300
        777160              / real k -400
        100620              / dummy i +400
        700620              / real k +400
        277324              / dummy j -300
        777160              / real k -400
        o22                 / to cell 22
        400000+o23+1        / to cell 24
c24,    000000              / cell 24: origin x 0
        000000              / cell 24: origin y 0
        022600              / cell 24: origin z 9600
        000023              / vectors 19
        500144              / real i +100
        100156              / dummy i +110
        500276              / real i +190
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        700620              / real k +400
        500050              / real i +40
        100156              / dummy i +110
        500372              / real i +250
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        200454              / dummy j +300
        777160              / real k -400
        100620              / dummy i +400
        700620              / real k +400
        277324              / dummy j -300
        777160              / real k -400
        o23                 / to cell 23
        400000+o24+1        / to cell 25
c25,    000000              / cell 25: origin x 0
        000000              / cell 25: origin y 0
        023420              / cell 25: origin z 10000
        000023              / vectors 19
        500050              / real i +40
        100156              / dummy i +110
        500372              / real i +250
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        700620              / real k +400
        500202              / real i +130
        100156              / dummy i +110
        500240              / real i +160
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        200454              / dummy j +300
        777160              / real k -400
        100620              / dummy i +400
        700620              / real k +400
        277324              / dummy j -300
        777160              / real k -400
        o24                 / to cell 24
        400000+o25+1        / to cell 26
c26,    000000              / cell 26: origin x 0
        000000              / cell 26: origin y 0
        024240              / cell 26: origin z 10400
        000023              / vectors 19
        500202              / real i +130
        100156              / dummy i +110
        500240              / real i +160
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        700620              / real k +400
        500106              / real i +70
        100156              / dummy i +110
        500334              / real i +220
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        200454              / dummy j +300
        777160              / real k -400
        100620              / dummy i +400
        700620              / real k +400
        277324              / dummy j -300
        777160              / real k -400
        o25                 / to cell 25
        400000+o26+1        / to cell 27
c27,    000000              / cell 27: origin x 0
        000000              / cell 27: origin y 0
        025060              / cell 27: origin z 10800
        000023              / vectors 19
        500106              / real i +70
        100156              / dummy i +110
        500334              / real i +220
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        700620              / real k +400
        500240              / real i +160
        100156              / dummy i +110
        500202              / real i +130
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        200454              / dummy j +300
        777160              / real k -400
        100620              / dummy i +400
        700620              / real k +400
        277324              / dummy j -300
        777160              / real k -400
        o26                 / to cell 26
        400000+o27+1        / to cell 28
c28,    000000              / cell 28: origin x 0
        000000              / cell 28: origin y 0
        025700              / cell 28: origin z 11200
        000023              / vectors 19
        500240              / real i +160
        100156              / dummy i +110
        500202              / real i +130
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        700620              / real k +400
        500144              / real i +100
        100156              / dummy i +110
        500276              / real i +190
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        200454              / dummy j +300
        777160              / real k -400
        100620              / dummy i +400
        700620              / real k +400
        277324              / dummy j -300
        777160              / real k -400
        o27                 / to cell 27
        400000+o28+1        / to cell 29
c29,    000000              / cell 29: origin x 0
        000000              / cell 29: origin y 0
        026520              / cell 29: origin z 11600
        000023              / vectors 19
        500144              / real i +100
        100156              / dummy i +110
        500276              / real i +190
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        700620              / real k +400
        500050              / real i +40
        100156              / dummy i +110
        500372              / real i +250
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        200454              / dummy j +300
        777160              / real k -400
        100620              / dummy i +400
        700620              / real k +400
        277324              / dummy j -300
        777160              / real k -400
        o28                 / to cell 28
        400000+o29+1        / to cell 30
c30,    000000              / cell 30: origin x 0
        000000              / cell 30: origin y 0
        027340              / cell 30: origin z 12000
        000023              / vectors 19
        500050              / real i +40
        100156              / dummy i +110
        500372              / real i +250
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        700620              / real k +400
        500202              / real i +130
        100156              / dummy i +110
        500240              / real i +160
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        200454              / dummy j +300
        777160              / real k -400
        100620              / dummy i +400
        700620              / real k +400
        277324              / dummy j -300
        777160              / real k -400
        o29                 / to cell 29
        400000+o30+1        / to cell 31
c31,    000000              / cell 31: origin x 0
        000000              / cell 31: origin y 0
        030160              / cell 31: origin z 12400
        000021              / vectors 17
        500202              / real i +130
        100156              / dummy i +110
        500240              / real i +160
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        700620              / real k +400
        500620              / real i +400
        600454              / real j +300
        577160              / real i -400
        677324              / real j -300
        200454              / dummy j +300
        777160              / real k -400
        100620              / dummy i +400
        700620              / real k +400
        277324              / dummy j -300
        777160              / real k -400
        400000+o30          / to cell 30
o0,     400000+c0           / opening 0: cell on the low side
        c1                  / cell on the high side
        000202              / opening 0: origin x 130
        000000              / opening 0: origin y 0
        000620              / opening 0: origin z 400
        000004              / vectors 4
        100156              / dummy i +110
        600322              / real j +210
        577622              / real i -110
        677456              / real j -210
o1,     400000+c1           / opening 1: cell on the low side
        c2                  / cell on the high side
        000106              / opening 1: origin x 70
        000000              / opening 1: origin y 0
        001440              / opening 1: origin z 800
        000004              / vectors 4
        100156              / dummy i +110
        600322              / real j +210
        577622              / real i -110
        677456              / real j -210
o2,     400000+c2           / opening 2: cell on the low side
        c3                  / cell on the high side
        000240              / opening 2: origin x 160
        000000              / opening 2: origin y 0
        002260              / opening 2: origin z 1200
        000004              / vectors 4
        100156              / dummy i +110
        600322              / real j +210
        577622              / real i -110
        677456              / real j -210
o3,     400000+c3           / opening 3: cell on the low side
        c4                  / cell on the high side
        000144              / opening 3: origin x 100
        000000              / opening 3: origin y 0
        003100              / opening 3: origin z 1600
        000004              / vectors 4
        100156              / dummy i +110
        600322              / real j +210
        577622              / real i -110
        677456              / real j -210
o4,     400000+c4           / opening 4: cell on the low side
        c5                  / cell on the high side
        000050              / opening 4: origin x 40
        000000              / opening 4: origin y 0
        003720              / opening 4: origin z 2000
        000004              / vectors 4
        100156              / dummy i +110
        600322              / real j +210
        577622              / real i -110
        677456              / real j -210
o5,     400000+c5           / opening 5: cell on the low side
        c6                  / cell on the high side
        000202              / opening 5: origin x 130
        000000              / opening 5: origin y 0
        004540              / opening 5: origin z 2400
        000004              / vectors 4
        100156              / dummy i +110
        600322              / real j +210
        577622              / real i -110
        677456              / real j -210
o6,     400000+c6           / opening 6: cell on the low side
        c7                  / cell on the high side
        000106              / opening 6: origin x 70
        000000              / opening 6: origin y 0
        005360              / opening 6: origin z 2800
        000004              / vectors 4
        100156              / dummy i +110
        600322              / real j +210
        577622              / real i -110
        677456              / real j -210
o7,     400000+c7           / opening 7: cell on the low side
        c8                  / cell on the high side
        000240              / opening 7: origin x 160
        000000              / opening 7: origin y 0
        006200              / opening 7: origin z 3200
        000004              / vectors 4
        100156              / dummy i +110
        600322              / real j +210
        577622              / real i -110
        677456              / real j -210
o8,     400000+c8           / opening 8: cell on the low side
        c9                  / cell on the high side
        000144              / opening 8: origin x 100
        000000              / opening 8: origin y 0
        007020              / opening 8: origin z 3600
        000004              / vectors 4
        100156              / dummy i +110
        600322              / real j +210
        577622              / real i -110
        677456              / real j -210
o9,     400000+c9           / opening 9: cell on the low side
        c10                 / cell on the high side
        000050              / opening 9: origin x 40
        000000              / opening 9: origin y 0
        007640              / opening 9: origin z 4000
        000004              / vectors 4
        100156              / dummy i +110
        600322              / real j +210
        577622              / real i -110
        677456              / real j -210
o10,    400000+c10          / opening 10: cell on the low side
        c11                 / cell on the high side
        000202              / opening 10: origin x 130
        000000              / opening 10: origin y 0
        010460              / opening 10: origin z 4400
        000004              / vectors 4
        100156              / dummy i +110
        600322              / real j +210
        577622              / real i -110
        677456              / real j -210
o11,    400000+c11          / opening 11: cell on the low side
        c12                 / cell on the high side
        000106              / opening 11: origin x 70
        000000              / opening 11: origin y 0
        011300              / opening 11: origin z 4800
        000004              / vectors 4
        100156              / dummy i +110
        600322              / real j +210
        577622              / real i -110
        677456              / real j -210
o12,    400000+c12          / opening 12: cell on the low side
        c13                 / cell on the high side
        000240              / opening 12: origin x 160
        000000              / opening 12: origin y 0
        012120              / opening 12: origin z 5200
        000004              / vectors 4
        100156              / dummy i +110
        600322              / real j +210
        577622              / real i -110
        677456              / real j -210
o13,    400000+c13          / opening 13: cell on the low side
        c14                 / cell on the high side
        000144              / opening 13: origin x 100
        000000              / opening 13: origin y 0
        012740              / opening 13: origin z 5600
        000004              / vectors 4
        100156              / dummy i +110
        600322              / real j +210
        577622              / real i -110
        677456              / real j -210
o14,    400000+c14          / opening 14: cell on the low side
        c15                 / cell on the high side
        000050              / opening 14: origin x 40
        000000              / opening 14: origin y 0
        013560              / opening 14: origin z 6000
        000004              / vectors 4
        100156              / dummy i +110
        600322              / real j +210
        577622              / real i -110
        677456              / real j -210
o15,    400000+c15          / opening 15: cell on the low side
        c16                 / cell on the high side
        000202              / opening 15: origin x 130
        000000              / opening 15: origin y 0
        014400              / opening 15: origin z 6400
        000004              / vectors 4
        100156              / dummy i +110
        600322              / real j +210
        577622              / real i -110
        677456              / real j -210
o16,    400000+c16          / opening 16: cell on the low side
        c17                 / cell on the high side
        000106              / opening 16: origin x 70
        000000              / opening 16: origin y 0
        015220              / opening 16: origin z 6800
        000004              / vectors 4
        100156              / dummy i +110
        600322              / real j +210
        577622              / real i -110
        677456              / real j -210
o17,    400000+c17          / opening 17: cell on the low side
        c18                 / cell on the high side
        000240              / opening 17: origin x 160
        000000              / opening 17: origin y 0
        016040              / opening 17: origin z 7200
        000004              / vectors 4
        100156              / dummy i +110
        600322              / real j +210
        577622              / real i -110
        677456              / real j -210
o18,    400000+c18          / opening 18: cell on the low side
        c19                 / cell on the high side
        000144              / opening 18: origin x 100
        000000              / opening 18: origin y 0
        016660              / opening 18: origin z 7600
        000004              / vectors 4
        100156              / dummy i +110
        600322              / real j +210
        577622              / real i -110
        677456              / real j -210
o19,    400000+c19          / opening 19: cell on the low side
        c20                 / cell on the high side
        000050              / opening 19: origin x 40
        000000              / opening 19: origin y 0
        017500              / opening 19: origin z 8000
        000004              / vectors 4
        100156              / dummy i +110
        600322              / real j +210
        577622              / real i -110
        677456              / real j -210
o20,    400000+c20          / opening 20: cell on the low side
        c21                 / cell on the high side
        000202              / opening 20: origin x 130
        000000              / opening 20: origin y 0
        020320              / opening 20: origin z 8400
        000004              / vectors 4
        100156              / dummy i +110
        600322              / real j +210
        577622              / real i -110
        677456              / real j -210
o21,    400000+c21          / opening 21: cell on the low side
        c22                 / cell on the high side
        000106              / opening 21: origin x 70
        000000              / opening 21: origin y 0
        021140              / opening 21: origin z 8800
        000004              / vectors 4
        100156              / dummy i +110
        600322              / real j +210
        577622              / real i -110
        677456              / real j -210
o22,    400000+c22          / opening 22: cell on the low side
        c23                 / cell on the high side
        000240              / opening 22: origin x 160
        000000              / opening 22: origin y 0
        021760              / opening 22: origin z 9200
        000004              / vectors 4
        100156              / dummy i +110
        600322              / real j +210
        577622              / real i -110
        677456              / real j -210
o23,    400000+c23          / opening 23: cell on the low side
        c24                 / cell on the high side
        000144              / opening 23: origin x 100
        000000              / opening 23: origin y 0
        022600              / opening 23: origin z 9600
        000004              / vectors 4
        100156              / dummy i +110
        600322              / real j +210
        577622              / real i -110
        677456              / real j -210
o24,    400000+c24          / opening 24: cell on the low side
        c25                 / cell on the high side
        000050              / opening 24: origin x 40
        000000              / opening 24: origin y 0
        023420              / opening 24: origin z 10000
        000004              / vectors 4
        100156              / dummy i +110
        600322              / real j +210
        577622              / real i -110
        677456              / real j -210
o25,    400000+c25          / opening 25: cell on the low side
        c26                 / cell on the high side
        000202              / opening 25: origin x 130
        000000              / opening 25: origin y 0
        024240              / opening 25: origin z 10400
        000004              / vectors 4
        100156              / dummy i +110
        600322              / real j +210
        577622              / real i -110
        677456              / real j -210
o26,    400000+c26          / opening 26: cell on the low side
        c27                 / cell on the high side
        000106              / opening 26: origin x 70
        000000              / opening 26: origin y 0
        025060              / opening 26: origin z 10800
        000004              / vectors 4
        100156              / dummy i +110
        600322              / real j +210
        577622              / real i -110
        677456              / real j -210
o27,    400000+c27          / opening 27: cell on the low side
        c28                 / cell on the high side
        000240              / opening 27: origin x 160
        000000              / opening 27: origin y 0
        025700              / opening 27: origin z 11200
        000004              / vectors 4
        100156              / dummy i +110
        600322              / real j +210
        577622              / real i -110
        677456              / real j -210
o28,    400000+c28          / opening 28: cell on the low side
        c29                 / cell on the high side
        000144              / opening 28: origin x 100
        000000              / opening 28: origin y 0
        026520              / opening 28: origin z 11600
        000004              / vectors 4
        100156              / dummy i +110
        600322              / real j +210
        577622              / real i -110
        677456              / real j -210
o29,    400000+c29          / opening 29: cell on the low side
        c30                 / cell on the high side
        000050              / opening 29: origin x 40
        000000              / opening 29: origin y 0
        027340              / opening 29: origin z 12000
        000004              / vectors 4
        100156              / dummy i +110
        600322              / real j +210
        577622              / real i -110
        677456              / real j -210
o30,    400000+c30          / opening 30: cell on the low side
        c31                 / cell on the high side
        000202              / opening 30: origin x 130
        000000              / opening 30: origin y 0
        030160              / opening 30: origin z 12400
        000004              / vectors 4
        100156              / dummy i +110
        600322              / real j +210
        577622              / real i -110
        677456              / real j -210
