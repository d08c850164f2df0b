(Q with a rapid motion)
G0 X10 Q5
M30
