(no address E or U)
G0 X1 E5
G0 u3
M2
