(the geometry is 0 or 1)
G10 L77 P6
N1 P1 Q1 R0 S0 T2
G11
M30
