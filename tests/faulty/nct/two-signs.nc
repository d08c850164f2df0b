(two signs)
G0 X--5
M30
