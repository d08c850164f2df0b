% LF
N1 (5 цифр по адресу T) LF
N2 T04040 LF
N3 M02 LF
