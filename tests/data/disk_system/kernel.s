/ A test system for the RB09: prompt, console by interrupts, sectors of track 0 read and written.
/   w N C  writes the character C as the first word of sector N (0 to 9), answers k
/   r N    reads sector N and types its first character
/   h      halts
/ An error of the disk is answered by !, a command that is none by ?
0/
        0                       / the interrupt leaves PC here
        jmp handle
100/
begin,  iof
        dzm kflag
        700042                  / ION
prompt, lac (52
        jms type
        jms getkey
        sad (162
        jmp reads
        sad (167
        jmp writes
        sad (150
        jmp ends
        lac (77
answer, jms type
        lac (15
        jms type
        lac (12
        jms type
        jmp prompt
ends,   700002                  / IOF
        hlt
reads,  jms getkey
        dac sector
        lac (6000               / interrupt enable, busy
        jms move
        jmp wrong
        lac buffer
        jmp answer
writes, jms getkey
        dac sector
        jms getkey
        dac buffer
        lac (7000               / interrupt enable, busy, write
        jms move
        jmp wrong
        lac (153
        jmp answer
wrong,  lac (41
        jmp answer

/ AC commands a transfer between `buffer` and the sector; returns behind the next word unless there was an error.
move,   0
        dac command
        707141                  / DBCS
        lac sector
        and (17
        707104                  / DBLD
        lac (buffer
        707142                  / DBLM
        lac (777700
        707124                  / DBLW
        dzm dflag
        lac command
        707144                  / DBLS
        lac dflag
        sna
        jmp .-2
        lac status
        sma
        isz move
        jmp i move

getkey, 0
        lac kflag
        sna
        jmp .-2
        dzm kflag
        lac key
        and (177
        jms type                / echo
        jmp i getkey

type,   0
        dac char
        dzm tflag
        700406                  / TLS
        lac tflag
        sna
        jmp .-2
        lac char
        jmp i type

handle, dac saved
        700301                  / KSF
        jmp .+4
        700312                  / KRB
        dac key
        dac kflag
        700401                  / TSF
        jmp .+4
        700402                  / TCF
        lac (1
        dac tflag
        707121                  / DBSF
        jmp .+5
        707132                  / DBRS
        dac status
        707101                  / DBCF
        dac dflag
        lac saved
        700042                  / ION
        jmp i 0

saved,  0
key,    0
kflag,  0
tflag,  0
dflag,  0
status, 0
char,   0
sector, 0
command, 0
buffer=500
        start begin
