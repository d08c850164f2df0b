(by its name)
#_ABSIO[1]=0
M30
