" The language of Bell Laboratories' as of 1970: each form once. Look at the listing beside it.
.. = 0                  " the program is for location 0 and up; without this line for 4096 and up
open = 3; write = 5     " names for values; those of system calls are the program's own
t = 0                   " an assignment can be changed later

. = 0100                " the location of what follows; octal, for it begins with 0
begin:                  " a label
   lac d10              " a name like others: a location with the number 10
   dac 9f+t             " the first temporary of this routine
1: tad dm1              " a relative label, 0: to 9:
   dac 9f+t+1 i         " i: indirect
   sza                  " skip if zero
   jmp 1b               " the label 1: before; 2f is the one behind
   spa cla              " a blank is OR
   jmp 2f
   sys open; name; 0    " cal i 3, and two words
2: hlt
t = t+2                 " that many temporaries

d10: 10                 " decimal
dm1: -1                 " 777777: two's complement
name: <na>; <me>; <s 012; x>    " two characters to a word, nine bits each
end: end-begin          " the difference of two locations is a number
9: . = .+t              " room for the temporaries
