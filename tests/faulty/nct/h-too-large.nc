(H is at most 999)
G43 Z10 H1000
M30
