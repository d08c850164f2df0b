(two points in a number)
G0 X1.2.3
M30
