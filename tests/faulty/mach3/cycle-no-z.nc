(Z missing and not sticky)
F100 S500 M3
G0 Z10
G81 X1 R2
M2
