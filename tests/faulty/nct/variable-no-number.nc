(# alone)
#2=#+1
M30
