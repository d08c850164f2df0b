(two P in a block)
G0 G54.1 P16 X100 Y20 M98 P1
M30
