(G1 and a cycle)
F100
G1 G81 X1 Z-1 R1
M2
