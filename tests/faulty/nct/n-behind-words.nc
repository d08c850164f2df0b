(the block number behind other words)
G0 X1 N10
M30
