(negative feed)
G1 X10 F-100
M2
