(sign at F)
G1 X10 F-100
M30
