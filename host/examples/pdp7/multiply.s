/ EAE: 6 times 7, then the product divided by 5. Look at AC and MQ at the end: remainder 2, quotient 10 (octal).
100/
begin,  lac (6
        cll             / MUL complements the product if L is 1
        mul
        7               / the other factor: the product is in AC (high) and MQ (low)
        lacq            / AC from MQ
        cll
        idiv
        5               / the divisor: quotient in MQ, remainder in AC
        hlt

        start begin
