(a dwell without its time)
G4
M30
