(number with two points)
G0 X1.2.3
M2
