% LF
N1 (X дважды) LF
N2 G00 X1. X2. LF
N3 M02 LF
