(one ] too many)
#1=[1+2]]
M30
