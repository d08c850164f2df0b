% LF
N1 (у X нет числа) LF
N2 G00 X Y1. LF
N3 M02 LF
