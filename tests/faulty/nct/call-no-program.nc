(M98 without P)
M98 L2
M30
