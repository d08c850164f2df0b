(spindles are 1 to 16)
G10 L52
N822 P17 R18
G11
M30
