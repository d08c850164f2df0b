(IF behind a word)
G0 X5 IF[1 EQ 1] GOTO10
N10 M30
