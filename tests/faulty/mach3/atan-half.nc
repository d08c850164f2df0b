(ATAN needs a second argument)
#3=ATAN[1]
M2
