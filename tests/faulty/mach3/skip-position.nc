(slash in the middle)
G0 /X1
M2
