/ Reads 256 words from track 180 of the RB09 to core 0 and begins at 100.
7700/
boot,   iof
        703302                  / CAF
        707141                  / DBCS
        lac (777400
        707124                  / DBLW
        cla
        707142                  / DBLM
        lac (300000             / track 180 in BCD
        707104                  / DBLD
        lac (2000               / busy
        707144                  / DBLS
        707121                  / DBSF
        jmp .-1
        707132                  / DBRS
        spa
        hlt
        jmp 100
        start boot
