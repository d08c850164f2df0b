(a position beyond all axes)
G0 X99999999999
M30
