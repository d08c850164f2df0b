(P without a code that takes it)
G0 X10 P5
M30
