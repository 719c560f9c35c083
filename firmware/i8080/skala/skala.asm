; Hidden lines, hidden surfaces and hidden contours on an 8080: the resident program.
;
; After V. Skala, "Hidden-Line, Hidden-Surface and Hidden-Contouring Problem Solutions by the Modified Bresenham's
; Algorithm", 1985. What it does with every byte it is sent is fixed by SPECIFICATION.md; NOTES.md says where each idea
; of the paper is here, and what the inner loops cost. Left out: interrupts (the link and the plotter are polled,
; the stack pointer is busy elsewhere) and reading a position back from any device (none can tell it).
;
; Assembled as one file, so that the loops, which change their own constants, can be laid out beside their data.

ATONCE  EQU     0
        INCLUDE program.asm

        END     START
