; The build with the facing test: SPECIFICATION.md, section 5. The other build is flight.asm.

FACING  EQU     1
        INCLUDE program.asm

        END     START
