(the count stands between the passes)
G0 X#1
#1=[#1+1]
M99
