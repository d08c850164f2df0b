(no such name)
#1=#_ABCDE[1]
M30
