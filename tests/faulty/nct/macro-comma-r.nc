(,R is no argument)
G65 P10 A1 ,R5
M30
O10
M99
