(axes are numbered from 1)
#1=#_ABSIO[0]
M30
