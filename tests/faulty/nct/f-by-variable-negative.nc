(negative feed by a variable)
#1=-5
G1 X1 F#1
M30
