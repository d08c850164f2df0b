(WHILE without DO)
#1=9
WHILE[#1 LT 5]
#1=#1+1
M30
