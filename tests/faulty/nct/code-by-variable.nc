(unknown code from a variable)
#1=77.3
G#1 X1
M30
