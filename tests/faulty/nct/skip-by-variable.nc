(number of the skip switch by a variable)
#100=2
/#100 G0 X10
M30
