(I in the plane YZ)
G19 G2 Y10 I3 J5 F100
M30
