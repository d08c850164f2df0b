(R less than half of the chord)
G2 X100 R30 F100
M30
