(no such subprogram, eight digits)
M98 P12345
M30
