(a number with a fraction)
#1=5.5
#2=#[#1]
M30
