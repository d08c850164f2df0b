(END1 with a word behind it: one fault)
#1=9
WHILE[#1 LT 10] DO1
#1=#1+1
END1 X5
M30
