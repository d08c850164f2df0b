(sign at H)
G43 H-1 Z0
M30
