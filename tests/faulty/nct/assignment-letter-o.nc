(#1OO=5: letters O)
#1OO=5
M30
