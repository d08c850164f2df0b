(probe target too close)
F100
G31 X0.1
M2
