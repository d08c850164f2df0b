%
N1 (G4 без E)
N2 G4
N3 M2
