(two assignments in a block)
#1=1 #2=2
M30
