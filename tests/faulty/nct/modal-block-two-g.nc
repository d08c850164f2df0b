(G66.1: two G in a block)
G66.1 P10
G0 G90 X5
G67
M30
O10
M99
