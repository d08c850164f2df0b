(no such L)
G10 L3 P1 X0
M30
