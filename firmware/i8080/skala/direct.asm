; The build without the temporary masks M1T and M1B: SPECIFICATION.md, section 10. The other build is skala.asm.

ATONCE  EQU     1
        INCLUDE program.asm

        END     START
