(G0 and G1 in one block)
G0 G1 X10 F100
M30
