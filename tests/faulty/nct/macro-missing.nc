(no such macro)
G65 P777 A1
M30
