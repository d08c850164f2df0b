(logarithm of zero)
G0 XLN[0]
M2
