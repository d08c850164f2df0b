(beyond the limit of the axis)
G0 X50
G0 Y1 X150
G0 X60
M2
