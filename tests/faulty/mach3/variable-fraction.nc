(parameter 1.5)
#1=1.5
G0 X##1
M2
