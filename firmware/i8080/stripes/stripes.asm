; Hidden surfaces by Parallel Connected Stripes on an 8080: the whole program.
;
; After C. Montani and M. Re, "Vector and Raster Hidden Surface Removal Using Parallel Connected Stripes", IEI Pisa B85-08,
; 1985. What it does with every byte it is sent is fixed by SPECIFICATION.md; NOTES.md says where each idea of the paper is
; here. Left out: interrupts (the stack pointer is busy in set operations), and faces in secondary storage (all are in memory).

COVER   EQU     0
OVERW   EQU     0
        INCLUDE program.asm

        END     START
