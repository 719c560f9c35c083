; The build that overwrites: SPECIFICATION.md, section 9. The other builds are stripes.asm and coverage.asm.

COVER   EQU     0
OVERW   EQU     1
        INCLUDE program.asm

        END     START
