(lead and threads per inch)
S100 M3
G33 Z-10 F2 E8
M30
