(no comparison)
IF[#1] GOTO10
N10 M30
