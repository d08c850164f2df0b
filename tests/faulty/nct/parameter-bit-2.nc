(a bit is 0 or 1)
G10 L52
N1746 Q1 R2
G11
M30
