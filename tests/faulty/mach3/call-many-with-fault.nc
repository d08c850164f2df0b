(the fault is in the subprogram: told once)
M98 P5 L99999999
M30
O5
G77
M99
