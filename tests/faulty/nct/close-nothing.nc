(FCLOS with nothing open)
FCLOS
M30
