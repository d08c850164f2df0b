% LF
N1 (глубина прохода 0) LF
N2 G87 X120. Y80. Z-10. B2. R12. I30 K0 J-1 F60 LF
N3 M02 LF
