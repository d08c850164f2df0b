(M takes eight digits)
M100000000
M30
