(a ninth I: #10 and #16 hold G and P)
G65 P10 I1 I2 I3 I4 I5 I6 I7 I8 I9 I10
M30
O10
M99
