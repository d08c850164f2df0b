(G12.1 with a motion)
G17 G0 X100 C0
G12.1 X50
M30
