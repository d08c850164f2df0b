(an operator without its right side)
#1=5+
M30
