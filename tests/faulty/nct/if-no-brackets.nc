(the condition without brackets)
IF #1 EQ 5 GOTO10
N10 M30
