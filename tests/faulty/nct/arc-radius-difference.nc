(the end does not lie on the circle)
G17 G90 G0 X50 Y0
G3 X-20 I-50 F100
M30
