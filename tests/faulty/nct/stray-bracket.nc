(closing round bracket without the opening one)
G0 X10 )
M30
