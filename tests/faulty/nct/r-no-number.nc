(R without a number)
G2 X10 Y10 R F100
M30
