(H not whole, negative, too large)
G43 H1.5
G43 H-1
G43 H256
M2
