; The parts of both builds. FACING: keys only for pieces that face the eye. SPECIFICATION.md, section 5.

        INCLUDE ../ports.asm
        INCLUDE equates.asm
        INCLUDE control.asm
        INCLUDE bytes.asm
        INCLUDE table.asm
        INCLUDE words.asm
        INCLUDE order.asm
        IF      FACING
CODEND  EQU     $               ; may not reach the squares
        ORG     MORE
        INCLUDE facing_test.asm
        INCLUDE cells.asm
MOREND  EQU     $               ; may not reach the entries
        ELSE
        INCLUDE cells.asm
CODEND  EQU     $               ; likewise
        ENDIF
