(G11 with a motion)
G10 L75 P3
N1
G11 X5
G11
M30
