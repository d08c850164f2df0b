(L without a call)
G0 X10 L5
M30
