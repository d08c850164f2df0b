(two values, no operator)
#1=#2 #3
M30
