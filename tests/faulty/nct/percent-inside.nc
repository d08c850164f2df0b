(% inside a block)
G0 X10 %
M30
