(G65 O10: the number belongs to P)
G65 O10 A1
M30
O10
M99
