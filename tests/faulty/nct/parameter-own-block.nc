(G10 L52 with an axis)
G10 L52 X5
M30
