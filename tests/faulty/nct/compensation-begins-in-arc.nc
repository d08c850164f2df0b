(compensation begins on a line)
G41 D1 G2 X10 R5 F100
G40
M30
