(G65 without P)
G65 A1 B2
M30
