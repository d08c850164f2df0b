(a subprogram that calls itself)
M98 P10
M30
O10
M98 P10
M99
