(probe in inverse time)
G93
G31 X10 F2
M2
