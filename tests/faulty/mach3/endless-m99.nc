(M99 without end)
G0 X1
G0 X0
M99
