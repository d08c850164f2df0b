(spindle stands)
F100
G0 Z10
G86 X1 Z-5 R2 P1
M2
