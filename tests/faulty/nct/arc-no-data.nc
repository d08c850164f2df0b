(neither R nor I, J, K)
G2 X10 Y10 F100
M30
