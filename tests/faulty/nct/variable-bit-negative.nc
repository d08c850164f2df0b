(a negative bit)
#_UO[3]=-1
M30
