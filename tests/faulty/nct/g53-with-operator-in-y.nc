(the second axis of G53 is an increment)
G53 X10 YI5
M30
