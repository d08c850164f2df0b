(a fixture is not turned)
G10 L2 P1 X1 R90
M30
