(PCLOS31 with nothing open)
PCLOS31
M30
