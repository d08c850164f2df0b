(X1O0: letter O inside a number)
G0 X1O0
M30
