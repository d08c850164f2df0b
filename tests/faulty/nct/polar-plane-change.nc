(another plane while G12.1 is on)
G17 G0 X100 C0
G12.1
G18
G13.1
M30
