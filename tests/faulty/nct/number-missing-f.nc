(F without a number)
G1 X5 F
M30
