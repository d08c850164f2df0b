(X1l: small letter l in place of the digit 1)
G0 X1l
M30
