(the number is an empty variable)
#1=PRM[#2]
M30
