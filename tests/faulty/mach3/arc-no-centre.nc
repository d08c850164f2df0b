(no centre)
F100
G2 X10 Y0
M2
