(faults in subprograms nobody calls)
G0 X1
M2
O10
G0 X1 X2
G77
M99
O20
#1=[FOO[1]]
M99
