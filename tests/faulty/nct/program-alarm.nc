(an alarm of the program)
G0 X5
#3000=12(NO TOOL)
M30
