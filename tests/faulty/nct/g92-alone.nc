(G92 without an axis)
G92
M30
