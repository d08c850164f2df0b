(operator missing)
#1=[2 #3]
M2
