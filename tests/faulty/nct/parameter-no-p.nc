(P is missing: an axis)
G10 L52
N108 R360
G11
M30
