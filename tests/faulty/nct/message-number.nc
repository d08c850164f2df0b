(three digits)
#3106=1000(HELLO)
M30
