(faults in both parts)
G77
M98 P10
M2
O10
G78
M99
O20
G79
M99
