(no such block)
GOTO500
M30
