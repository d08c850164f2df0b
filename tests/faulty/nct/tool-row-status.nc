(the life status is at most 4)
G10 L75 P1
N1
T5 Q10001 B5
G11
M30
