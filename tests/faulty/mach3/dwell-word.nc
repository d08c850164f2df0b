(G4 without P)
G4
M2
