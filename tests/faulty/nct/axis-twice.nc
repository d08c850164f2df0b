(X twice)
G0 X10 X20
M30
