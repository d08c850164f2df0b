(M47 without end)
G0 X1
M47
