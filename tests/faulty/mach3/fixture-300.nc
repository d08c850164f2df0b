(fixture 300)
G59 P300
M2
