(revolutions of a spindle that stands)
G95
G4 P10
M30
