(nothing of a faulty block is done: F stays unset)
G0 X1 F100 X2
G1 X5
M2
