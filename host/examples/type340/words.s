/ Display words alone, for `sightline disasm type340`. Look at the comments that it writes: they say how the display reads each word.
200/
        020117
        220400
        100400
        200100
        640100
        003000
