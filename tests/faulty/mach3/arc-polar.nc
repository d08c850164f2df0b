(arc in polar mode)
F100
G16
G2 X10 Y45 I5
M2
