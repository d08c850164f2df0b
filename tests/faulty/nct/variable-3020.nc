(a variable of other controls)
#3020=1
M30
