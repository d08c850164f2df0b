(one fault; the call behind it is left after a pass)
G1 X5 F0
M98 P5 L99999999
M30
O5
G0 X1
M99
