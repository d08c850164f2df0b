(I, J, K on the cylinder)
G19 Y0 C0
G7.1 C50
G2 Y10 C5 J5 F100
G7.1 C0
M30
