(full circle by R)
F100
G2 X0 Y0 R5
M2
