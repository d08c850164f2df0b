(root of a negative number)
#1=SQRT[0-4]
M2
