(a rotary axis moves in a cycle)
F100 S500 M3
G0 Z10
G81 X1 Z-5 R2 A90
M2
