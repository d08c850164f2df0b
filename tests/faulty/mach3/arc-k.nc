(K in the plane XY)
F100
G2 X10 Y0 I5 K3
M2
