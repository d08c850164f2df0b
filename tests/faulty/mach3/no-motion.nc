(axis word under G80)
G80
X5
M2
