(X twice)
G0 X1 Y2 X3
M2
