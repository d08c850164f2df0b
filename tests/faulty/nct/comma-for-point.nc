(decimal comma)
G0 X10,5 Y3
M30
