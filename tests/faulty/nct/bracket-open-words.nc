(a bracket open before the next word)
G0 X[1+2 Y5
M30
