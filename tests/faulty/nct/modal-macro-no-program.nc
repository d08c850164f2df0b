(G66 without P)
G66 A1
G67
M30
