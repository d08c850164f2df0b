(M8 and M9 of one group of the builder)
M8 M9
M30
