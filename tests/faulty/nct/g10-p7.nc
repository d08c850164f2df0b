(G10 L2 goes up to P6)
G10 L2 P7 X0
M30
