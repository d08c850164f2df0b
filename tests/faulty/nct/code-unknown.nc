(a code that the control does not have)
G123 X10
M30
