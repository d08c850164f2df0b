(the rotary axis is not at 0)
G17 G0 X100 C30
G12.1
M30
