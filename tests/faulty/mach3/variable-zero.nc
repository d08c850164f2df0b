(parameter 0)
#0=1
M2
