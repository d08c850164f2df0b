(the block number by a variable)
#100=5
N#100 G0 X1
M30
