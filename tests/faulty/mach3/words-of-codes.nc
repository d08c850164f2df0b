(words in the wrong place or out of range)
G49 P1
G28 P1
G10 L1 P999 Z1
G10 L2 P0 X1
G59 P1.5
G4 P-1
F100
G12 I0
N10 N20 G0 X1
M98 P1.5
O
M2
