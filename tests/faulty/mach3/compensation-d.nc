(D not whole, negative, too large)
G41 D1.5
G41 D-1
G41 D256
M2
