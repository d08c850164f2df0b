(WHILE without DO, but with END: one fault)
#1=9
WHILE[#1 LT 5]
#1=#1+1
END1
M30
