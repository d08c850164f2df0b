(a position)
#5041=0
M30
