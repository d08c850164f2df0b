(an equals sign alone)
G0 X5 = Y5
M30
