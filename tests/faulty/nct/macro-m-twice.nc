(a second M in a block of G65)
G65 P10 M3 M4
M30
O10
M99
