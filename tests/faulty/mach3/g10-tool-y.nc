(a tool has no Y)
G10 L1 P1 Z1 Y2
M30
