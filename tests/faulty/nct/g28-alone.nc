(G28 without an axis)
G28
M30
