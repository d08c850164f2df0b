(a comment that is never closed)
G0 X10 Y5
G1 Z-1 F100 (to the depth
X20
M30
