(a macro that calls itself)
G65 P10 A1
M30
O10
G65 P10 A#1
M99
