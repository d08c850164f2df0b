(a fault behind a comment over lines)
G0 X10 (one
two
three) Y1 Z
M30
