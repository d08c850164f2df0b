(cycle in inverse time)
G93
G81 X1 Z-1 R1 F10
M2
