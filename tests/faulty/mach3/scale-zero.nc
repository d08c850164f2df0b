(scale 0)
G51 X0
M2
