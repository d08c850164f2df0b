(X and AX[1])
G0 X5 AX[1]=10
M30
