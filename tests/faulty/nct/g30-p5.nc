(there are four reference points)
G30 X0 P5
M30
