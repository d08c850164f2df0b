(bits are 0 to 7)
#1=PRM[107,8]/[1]
M30
