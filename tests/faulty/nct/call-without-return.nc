(a subprogram without M99)
M98 P10
M30
O10
G0 X5
