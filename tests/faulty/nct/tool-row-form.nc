(the form number is at most 20)
G10 L75 P1
N1
T5 A21
G11
M30
