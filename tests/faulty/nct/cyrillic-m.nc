(Cyrillic M and C: both read)
М8
G0 X1
M30
