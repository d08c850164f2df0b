(IF without GOTO)
IF[#1 EQ 5] 10
N10 M30
