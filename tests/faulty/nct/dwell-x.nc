(G4 X2 of other controls)
G4 X2
M30
