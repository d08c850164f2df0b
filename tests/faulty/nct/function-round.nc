(ROUND is not a function of this control)
#1=ROUND[2.5]
M30
