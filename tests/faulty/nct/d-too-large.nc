(D is at most 999)
G0 X1 D1000
M30
