(no subprogram 99)
M98 P99
M2
