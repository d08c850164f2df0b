(G5.1 without Q)
G5.1 X0 Y0
M30
