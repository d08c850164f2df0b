(G30 without an axis)
G30 P2
M30
