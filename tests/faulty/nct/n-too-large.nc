(N takes eight digits)
N100000000 G0 X1
M30
