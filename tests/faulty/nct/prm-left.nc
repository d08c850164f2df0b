(PRM on the left)
PRM[1339]=1
M30
