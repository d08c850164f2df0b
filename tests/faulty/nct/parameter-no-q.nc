(Q is missing: a bit)
G10 L52
N1746 R1
G11
M30
