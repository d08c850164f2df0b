(operator I on F)
G1 X10 FI100
M30
