% LF
N1 (длина паза не задана) LF
N2 G87 Y80. Z-10. B2. R12. I30 K10. J1 F60 LF
N3 M02 LF
