(an assignment, then a word)
#1=1 X5
M30
