(a thread on three axes)
S100 M3
G33 X5 Y5 Z-10 F2
M30
