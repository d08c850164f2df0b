(two one-shot codes)
G4 P1 G28 X0
M30
