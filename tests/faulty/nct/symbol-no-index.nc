(#_ABSIO takes an index)
#1=#_ABSIO + 1
M30
