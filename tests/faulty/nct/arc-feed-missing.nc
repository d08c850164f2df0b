(no feed before G2)
G2 X10 R5
M30
