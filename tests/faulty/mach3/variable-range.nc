(parameter beyond 10320)
#10321=1
G0 X#20000
M2
