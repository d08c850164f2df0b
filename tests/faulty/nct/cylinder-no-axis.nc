(G7.1 without the rotary axis)
G7.1
M30
