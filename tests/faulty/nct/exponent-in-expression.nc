(1E3 in an expression)
#1=1E3
M30
