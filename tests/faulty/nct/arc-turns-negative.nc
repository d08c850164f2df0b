(negative number of turns)
#1=-2
G2 X10 I5 L#1 F100
M30
