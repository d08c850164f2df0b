(positioning with the loop open)
G90 CS30
M30
