G21 G90 F100
O1 sub
G1 X1
O1 endsub
O1 call [2] [3
G0 Y5
M2
