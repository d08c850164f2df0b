(N is missing)
G10 L52
P1 R0.5
G11
M30
