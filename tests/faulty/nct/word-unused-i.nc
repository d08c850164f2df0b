(I with a straight line)
G1 X10 I5 F100
M30
