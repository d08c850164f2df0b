(a remark behind a semicolon)
G0 X10 ; to the start
M30
