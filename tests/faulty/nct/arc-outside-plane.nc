(G2 in force, only Z in the block)
G2 X10 I5 F100
Z5
M30
