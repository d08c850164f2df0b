(there are 999 offsets)
G10 L10 P1000 R5
M30
