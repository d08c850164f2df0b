(DO without END)
#1=5
WHILE[#1 LT 3] DO1
#1=#1+1
M30
