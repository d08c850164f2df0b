(cycle without a feed)
G0 Z10
G81 X1 Z-5 R2
M2
