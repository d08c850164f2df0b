(a rotary axis moves)
F100
G31 X10 A5
M2
