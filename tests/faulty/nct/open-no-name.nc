(FOPEN without a file)
FOPEN2
M30
