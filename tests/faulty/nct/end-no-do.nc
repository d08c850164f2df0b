(END without DO)
#1=1
END1
M30
