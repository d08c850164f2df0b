(N0106 needs a restart)
G10 L52
N106 P1 Q0 R1
G11
M30
