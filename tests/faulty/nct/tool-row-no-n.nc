(data without a row)
G10 L75 P1
T5 Q10001
G11
M30
