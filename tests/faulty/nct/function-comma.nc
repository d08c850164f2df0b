(ATAN takes one argument)
#1=ATAN[1,2]
M30
