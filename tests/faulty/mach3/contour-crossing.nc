(in and out along the extensions of two sides: no cut)
F500
G0 X-40 Y-40
G41 P5 G1 X0 Y-30
Y40
X60
Y0
X-30
G40
X-40 Y-40
M30
