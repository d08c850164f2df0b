(a word, then an assignment)
G0 X5 #1=1
M30
