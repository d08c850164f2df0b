(a remark behind two slashes)
G0 X10 // to the start
M30
