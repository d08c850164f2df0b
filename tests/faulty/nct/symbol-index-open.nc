(the bracket of the index)
#1=#_ABSIO[1
M30
