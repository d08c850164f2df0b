(one ] too many behind a word)
G0 X[1+2]]
M30
