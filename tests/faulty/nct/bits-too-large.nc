(AND of a number beyond 32 bits)
#1=99999999999
#2=#1 AND 1
M30
