(two motions of a group)
G0 G1 X1 F100
M2
