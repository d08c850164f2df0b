(N behind other words)
G0 X1 N20
M2
