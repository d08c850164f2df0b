(no number behind Y)
G0 X1 Y
M2
