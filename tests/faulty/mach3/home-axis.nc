(G28.1 without an axis)
F100
G28.1
M2
