(P belongs to nothing)
G0 X1 P5
G1 Y1 F100 H2
M2
