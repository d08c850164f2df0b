(G10 without P or L)
G10 L2 X1
G10 P1 X1
M2
