(a chamfer too short for the tool: the check is off)
G17 G90 G40 G0 X-20 Y0
G41 G1 X0 D1 F500
X45
X50 Y5
Y50
G40 Y70
M30
