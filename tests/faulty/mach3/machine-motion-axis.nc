(G53 without an axis)
G0 G53
M2
