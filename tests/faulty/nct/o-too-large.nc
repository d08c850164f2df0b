(O takes eight digits)
O100000000
G0 X1
M30
