(Cyrillic letter in place of X)
G0 Х10
M30
