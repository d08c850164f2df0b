(either or)
G1 X10 ,C2 ,R3 F100
Y10
M30
