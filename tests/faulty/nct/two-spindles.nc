(two spindles in one block)
S1=500 S2=1000 M3
M30
