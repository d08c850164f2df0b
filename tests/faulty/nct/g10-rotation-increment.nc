(operator I on the angle J)
G10 L2 P1 JI30
M30
