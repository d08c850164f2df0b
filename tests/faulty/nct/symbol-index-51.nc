(up to 50)
#1=#_ABSIO[51]
M30
