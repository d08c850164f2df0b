(the end is not on the circle)
F100
G3 X10 Y1 I5 J0
M2
