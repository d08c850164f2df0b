(Q takes binary digits)
G10 L75 P1
N1
T5 Q10002
G11
M30
