(,C is not yet there)
G1 X10 ,C2 F100
M30
