(a bit from the PLC)
#1000=1
M30
