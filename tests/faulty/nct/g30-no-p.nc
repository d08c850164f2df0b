(G30 without the point)
G30 X0
M30
