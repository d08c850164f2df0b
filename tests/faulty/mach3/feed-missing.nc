(G1 without a feed)
G1 X10
G1 X20 F100
M2
