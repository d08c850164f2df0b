(one of two is open)
#1=[[2+3]*4
M30
