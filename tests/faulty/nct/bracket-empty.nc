(nothing between the brackets)
#1=[]
M30
