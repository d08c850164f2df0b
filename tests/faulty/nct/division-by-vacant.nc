(division by an empty variable)
#2=5/#1
M30
