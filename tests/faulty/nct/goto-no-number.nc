(GOTO alone)
GOTO
M30
