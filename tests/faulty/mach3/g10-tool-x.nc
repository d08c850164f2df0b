(a mill's tool has no offset along X)
G10 L1 P1 Z1 X2
M30
