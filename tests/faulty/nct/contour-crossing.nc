(in and out along the extensions of two sides: no cut)
G90 G17 G40 G0 X-40 Y-40
G41 D1 G1 X0 Y-30 F500
Y40
X60
Y0
X-30
G40 X-40 Y-40
M30
