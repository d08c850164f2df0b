(M by a variable out of range)
#112=123456789
M#112
M30
