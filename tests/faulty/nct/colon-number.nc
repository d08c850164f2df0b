(program number of other controls)
:0100
G0 X10
M30
