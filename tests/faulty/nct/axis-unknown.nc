(the machine has no axis B)
G0 X10 B90
M30
