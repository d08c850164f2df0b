(S takes eight digits)
S100000000 M3
M30
