(the bracket of the condition is open)
IF[#1 EQ 5 GOTO10
N10 M30
