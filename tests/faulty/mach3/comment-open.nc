(comment not closed)
G0 X1 (to the start
M2
