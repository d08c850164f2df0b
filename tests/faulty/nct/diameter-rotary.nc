(G10.9 on a rotary axis)
G10.9 C1
M30
