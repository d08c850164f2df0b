(one fault, one alarm: the feed of a faulty block counts for those behind it in a check)
G0 X1 F100 X2
G1 X5
M2
