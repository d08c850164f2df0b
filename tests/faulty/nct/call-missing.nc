(no such subprogram)
M98 P7777
M30
