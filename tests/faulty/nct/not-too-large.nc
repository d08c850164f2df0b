(NOT of a number beyond 32 bits)
#1=NOT[-99999999999]
M30
