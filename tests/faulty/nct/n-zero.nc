(N begins at 1)
N0 G0 X1
M30
