(G without a number)
G X5
M30
