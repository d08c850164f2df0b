(a motion between G10 L52 and G11)
G10 L52
N1339 R0.5
G0 X10
G11
M30
