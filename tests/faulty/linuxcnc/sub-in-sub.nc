G21 G90 F100
O1 sub
G0 X1
O1 endsub
o<wraps> sub
O2 call
o<wraps> endsub
O3 call
G0 X5
M2
O3 sub
O4 sub
G0 X3
O4 endsub
O3 endsub
