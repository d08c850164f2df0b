%
N1 (конец строки CR LF)
N2 G1 X1000 F100 F200
N3 M2 X
N4 M2
