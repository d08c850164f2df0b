(Cyrillic letter without a Latin twin)
G0 X1 Ж5
M30
