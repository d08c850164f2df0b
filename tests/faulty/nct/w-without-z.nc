(W, but no axis Z)
G0 X5 W5
M30
