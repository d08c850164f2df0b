(1.5E3: no such notation; E is an address)
G0 X1.5E3
M30
