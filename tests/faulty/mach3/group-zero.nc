(G4 and G92 are both of group 0)
G4 P1 G92 X0
M2
