(G10 without L)
G10 P1 X0
M30
