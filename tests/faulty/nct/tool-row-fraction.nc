(a fraction of a use)
G10 L75 P2
N1
C1.5
G11
M30
