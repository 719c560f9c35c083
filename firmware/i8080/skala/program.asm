; The parts of both builds. ATONCE: without the temporary masks M1T and M1B (SPECIFICATION.md, section 10).

        INCLUDE ../ports.asm
        INCLUDE equates.asm
        INCLUDE monitor.asm
        INCLUDE commands.asm
        INCLUDE steps.asm
        INCLUDE masks.asm
        INCLUDE testdraw.asm
        INCLUDE lines.asm
        INCLUDE upright.asm
        INCLUDE plain.asm
        INCLUDE curve.asm
        INCLUDE surface.asm
        INCLUDE slice.asm
        INCLUDE fill.asm
        INCLUDE contours.asm
        INCLUDE boards.asm
        INCLUDE plotter.asm

CODEND  EQU     $               ; may not reach the masks
