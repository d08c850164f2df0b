(there is no #99)
#1=#99
M30
