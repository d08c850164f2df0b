(sign at M)
M-8
M30
