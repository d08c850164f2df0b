(negative radius of the cylinder)
G19 Y0 C0
G7.1 C-50
M30
