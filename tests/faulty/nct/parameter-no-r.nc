(R is missing)
G10 L52
N1339
G11
M30
