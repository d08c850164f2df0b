% LF
N1 (корректор 1.5) LF
N2 G00 X10. L1.5 LF
N3 M02 LF
