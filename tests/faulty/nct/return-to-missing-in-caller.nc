(M99 P: the caller has no such block)
M98 P10
M30
O10
N500 G0 X1
M99 P600
