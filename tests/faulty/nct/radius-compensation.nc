(a radius other than 0 in G41)
G41 D1 G1 X10 F100
G40
M30
