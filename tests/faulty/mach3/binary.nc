(bytes that are no text)
G0 X1  Y1
G0 !X2
M2
