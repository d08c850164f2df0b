(a negative dwell)
G4 P-1
M30
