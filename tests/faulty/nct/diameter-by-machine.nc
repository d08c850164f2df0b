(MGD = 0: the machine switches)
G10.9 X1
M30
