(spindle stands, then turns the other way)
F100
G0 Z10
G84 X1 Z-5 R2
S500 M4
G84 X2 Z-5 R2
M2
