(operator I on J)
G2 X10 JI5 F100
M30
