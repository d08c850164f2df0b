(radius by P)
G41 P2.5
M2
