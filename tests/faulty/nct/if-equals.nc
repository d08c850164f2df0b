(= in place of EQ)
IF[#1=5] GOTO10
N10 M30
