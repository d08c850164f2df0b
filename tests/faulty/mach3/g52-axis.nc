(G52, G92 without an axis)
G52
G92
M2
