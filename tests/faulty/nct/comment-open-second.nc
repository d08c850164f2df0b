(the second comment is never closed)
G0 X10 (start)
G1 Z-1 F100 (depth) (and ( more
X20
M30
