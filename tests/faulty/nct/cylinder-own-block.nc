(G7.1 with a motion)
G19 Y0 C0
G7.1 C50 M8
M30
