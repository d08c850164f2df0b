(the axis is missing)
#1=PRM[107,0]
M30
