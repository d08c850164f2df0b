(G12 without I)
F100
G12
M2
