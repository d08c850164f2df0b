(G10.9 without an axis)
G10.9
M30
