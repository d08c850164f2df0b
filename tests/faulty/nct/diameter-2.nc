(G10.9 takes 0 and 1)
G10.9 X2
M30
