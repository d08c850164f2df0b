(round brackets: a comment, then nothing)
#1=(2+3)*4
M30
