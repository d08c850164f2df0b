(unknown G and M)
G77 X1
M77
G0 G5.1
M2
