(no X, Y, Z)
F100
G31 A5
M2
