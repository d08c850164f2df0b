(G49 during fine smoothing)
G43 H1 Z10
G5.1 Q3 X0 Y0 Z0
G49
G5.1 Q0
M30
