(R with a straight line)
G1 X10 R5 F100
M30
