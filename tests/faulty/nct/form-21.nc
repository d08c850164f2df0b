(there are 20 forms)
G10 L77 P6
N21 P1
G11
M30
