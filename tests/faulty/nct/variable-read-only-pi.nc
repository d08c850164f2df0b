(the number pi)
#3101=3
M30
