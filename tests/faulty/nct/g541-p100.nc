(G54.1 goes up to P99)
G54.1 P100
M30
