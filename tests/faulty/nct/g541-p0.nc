(G54.1 begins at P1)
G54.1 P0
M30
