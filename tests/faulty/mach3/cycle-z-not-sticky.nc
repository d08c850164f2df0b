(Z of another cycle is not sticky)
F100 S500 M3
G0 Z10
G81 X1 Z-5 R2
G82 X2 P1
M2
