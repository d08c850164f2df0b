(X without a number in a motion block)
G1 X F100
M30
