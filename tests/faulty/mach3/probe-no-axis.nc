(probe without an axis)
F100
G31
M2
