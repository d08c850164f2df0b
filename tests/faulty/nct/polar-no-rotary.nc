(no rotary axis named with the plane)
G17 G0 X100
G12.1
M30
