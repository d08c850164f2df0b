%012 LF
N1 (дуга не сходится) LF
N2 G00 X0. Y0. LF
N3 G02 X10. Y1. I5. J0. F10. LF
N4 M02 LF
