% LF
N1 (адреса D нет) LF
N2 G00 X1. D1 LF
N3 M02 LF
