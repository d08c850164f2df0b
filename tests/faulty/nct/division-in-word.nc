(division by zero after an address)
G0 X[10/0]
M30
