(a modal code)
#4001=1
M30
