(IF without a condition)
IF GOTO10
N10 M30
