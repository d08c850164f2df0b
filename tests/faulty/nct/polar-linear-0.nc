(the linear axis is at 0)
G17 G0 X0 C0
G12.1
M30
