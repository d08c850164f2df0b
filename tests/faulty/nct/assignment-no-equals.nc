(= is missing)
#1 5
M30
