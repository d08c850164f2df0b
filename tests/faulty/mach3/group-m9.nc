(M9 with M8)
M8 M9
M2
