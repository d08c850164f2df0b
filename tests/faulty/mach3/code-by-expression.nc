(unknown code from a parameter)
#1=77
G#1 X1
M2
