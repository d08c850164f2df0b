(K in the plane XY)
G17 G2 X10 I5 K3 F100
M30
