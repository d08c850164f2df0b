(a tool that the table does not have)
T7 M6
M30
