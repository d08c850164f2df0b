(Cyrillic О in GOTO)
IF[1 EQ 1] GОTO10
N10 M30
