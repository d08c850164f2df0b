(G10 L10 without the value)
G10 L10 P1
M30
