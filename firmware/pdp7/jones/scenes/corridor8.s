/ scene corridor8: 8 cells in 194 words, 7 openings in 70, header 11
scene,  c0                  / initial cell
        000010              / number of cells 8
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
        000021              / vectors 17
        500106              / real i +70
        100156              / dummy i +110
        500334              / real i +220
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
        400000+o6           / to cell 6
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
