G21 G90 F100
G2 X10 Y0 I5 J2
G0 X#<width>
G0 X5 P2
(ABORT, no more than #1 holes)
M2
