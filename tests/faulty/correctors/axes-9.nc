% LF
N1 (осей 9, сумма больше 7) LF
N2 L9 15 LF
N3 M02 LF
