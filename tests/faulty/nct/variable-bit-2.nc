(a bit takes 0 and 1)
#1100=2
M30
