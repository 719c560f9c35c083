; The build with antialiasing: SPECIFICATION.md, section 8. The other builds are stripes.asm and overwrite.asm.

COVER   EQU     1
OVERW   EQU     0
        INCLUDE program.asm

        END     START
