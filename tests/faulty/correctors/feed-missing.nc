% LF
N1 (нет подачи) LF
N2 G01 X1. LF
N3 M02 LF
