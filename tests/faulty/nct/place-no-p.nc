(a place without the pocket)
G10 L76 P1
N1 R5
G11
M30
