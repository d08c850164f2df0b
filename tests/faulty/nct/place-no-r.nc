(a place without the data number)
G10 L76 P1
N1 P5
G11
M30
