(G10 L2 without P)
G10 L2 X0
M30
