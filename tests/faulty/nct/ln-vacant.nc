(LN of an empty variable)
#1=LN#2
M30
