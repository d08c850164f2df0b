(G54.12: no such code)
G54.12 X10
M30
