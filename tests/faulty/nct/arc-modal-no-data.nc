(a block without centre while G3 is in force)
G3 X10 I5 F100
X20
M30
