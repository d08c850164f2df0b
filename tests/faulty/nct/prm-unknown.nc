(there is no N9999)
#1=PRM[9999]
M30
