(R too small)
F100
G2 X10 Y0 R4
M2
