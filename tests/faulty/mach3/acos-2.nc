(arc cosine of 2)
#3=ACOS[2]
M2
