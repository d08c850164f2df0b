(#3000 cannot be read)
#1=#3000
M30
