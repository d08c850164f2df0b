(division by zero)
#2=0
G0 X[10/#2]
M2
