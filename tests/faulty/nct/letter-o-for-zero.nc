(letter O in place of the digit 0)
G1 X1O F100
M30
