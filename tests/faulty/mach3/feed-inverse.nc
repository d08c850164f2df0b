(G93 needs F in each block)
G93 G1 X10 F2
G1 X20
M2
