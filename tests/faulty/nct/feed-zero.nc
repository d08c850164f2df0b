(F0 before G1)
G1 X10 F0
M30
