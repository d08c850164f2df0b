(a number too large)
#1=#1000000
M30
