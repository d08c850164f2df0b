%012 LF
N1 (Q никому не нужно) LF
N2 G00 X1. Q5. LF
N3 M02 LF
