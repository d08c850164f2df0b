(a control character in the line)
G0 X10 Y5
M30
