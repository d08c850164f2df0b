(G54.1 without P)
G54.1 X10
M30
