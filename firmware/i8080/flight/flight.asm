; Priorities for a flight on an 8080: distances, order, and the priority display, frame by frame.
;
; After P. J. Willis, "A real time hidden surface technique", 1977. What it does with every byte it is sent is fixed by
; SPECIFICATION.md; NOTES.md says what each part costs. Left out: all that has to do with the screen, which is the host's part and
; the display's, and interrupts (link and display are polled; the stack pointer reads the coordinates).

FACING  EQU     0
        INCLUDE program.asm

        END     START
