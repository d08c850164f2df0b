(bits are 0 to 7)
G10 L52
N1746 Q8 R1
G11
M30
