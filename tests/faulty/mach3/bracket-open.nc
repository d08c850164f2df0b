(bracket not closed)
G0 X[1+2
M2
