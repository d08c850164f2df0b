(G7.1 with a linear axis)
G19 Y0 C0
G7.1 Y50
M30
