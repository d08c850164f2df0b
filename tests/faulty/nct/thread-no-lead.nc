(no lead at all)
S100 M3
G33 Z-10
M30
