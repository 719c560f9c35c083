; The parts of every build. COVER: with the coverage of the dots at sides; OVERW: drawn from the back, each face over those
; behind it. SPECIFICATION.md, sections 8 and 9.

PLOTS   EQU     1-COVER-OVERW   ; with output on the plotter

        INCLUDE ../ports.asm
        INCLUDE equates.asm
        INCLUDE monitor.asm
        INCLUDE check.asm
        INCLUDE build.asm
        INCLUDE sets.asm
        INCLUDE arith.asm
        INCLUDE depth.asm
        INCLUDE rank.asm
        INCLUDE draw.asm
        IF      COVER
        INCLUDE cover.asm
        ENDIF
        IF      PLOTS
        INCLUDE trace.asm
        INCLUDE plotter.asm
        ENDIF

CODEND  EQU     $               ; may not reach FS
