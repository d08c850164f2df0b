(rows begin at 1)
G10 L75 P1
N0
G11
M30
