(##: the number of a variable by a variable)
#120=5
#1=##120
M30
