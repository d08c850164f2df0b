(M99 to a block that is not there)
/M99 P500
M30
