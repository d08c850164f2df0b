(channels are 1 to 8)
G10 L52
N1339 P9 R0.1
G11
M30
