(M98 without P)
M98
M2
