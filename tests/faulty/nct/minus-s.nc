(sign at S)
S-500 M3
M30
