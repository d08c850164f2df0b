(J in the plane ZX)
G18 G2 X10 K5 J3 F100
M30
