(G51 is not yet there)
G51 X0 Y0 P2
M30
