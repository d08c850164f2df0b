(an axis Z2 of another channel)
G0 X10 Z2=5
M30
