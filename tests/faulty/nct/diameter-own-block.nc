(G10.9 with another code)
G10.9 X1 M8
M30
