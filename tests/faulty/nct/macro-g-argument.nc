(G as an argument of G65)
G65 P10 G81
M30
O10
M99
