(a spindle of channel 2)
S2=1000 M3
M30
