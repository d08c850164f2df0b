(FOPEN3: append to what is not there)
FOPEN3 P77
M30
