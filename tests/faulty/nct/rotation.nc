(G68 is not yet there)
G68 X0 Y0 R45
M30
