(a motion between G10 and G11)
G10 L75 P1
N1
T5 Q10001
G0 X10
G11
M30
