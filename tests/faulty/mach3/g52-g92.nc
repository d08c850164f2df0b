(G52 while G92 is in force)
G92 X5
G52 X1
M2
