(PRM without a number)
#1=PRM[]
M30
