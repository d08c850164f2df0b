(G68 without R)
G68 A0 B0
M2
