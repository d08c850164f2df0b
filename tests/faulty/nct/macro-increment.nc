(operator I in an argument)
G65 P10 XI5
M30
O10
M99
