(no feed before G1)
G1 X10
M30
