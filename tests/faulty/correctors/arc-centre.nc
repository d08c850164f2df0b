% LF
N1 (дуга без центра) LF
N2 G02 X1. Y1. F10 LF
N3 M02 LF
