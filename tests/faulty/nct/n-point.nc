(a point in the block number)
N1.5 G0 X1
M30
