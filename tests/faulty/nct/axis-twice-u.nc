(X and U: the same axis twice)
G0 X10 U20
M30
