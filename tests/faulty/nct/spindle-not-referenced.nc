(an absolute position after the closing code)
S0 M24
G90 CS30
M30
