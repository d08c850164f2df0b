(nothing follows that a chamfer could go to)
G1 X10 ,C2 F100
M30
