(#0 is empty for ever)
#0=1
M30
