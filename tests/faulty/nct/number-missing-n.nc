(N without a number)
N G0 X5
M30
