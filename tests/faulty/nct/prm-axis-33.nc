(axes are 1 to 32)
#1=PRM[108]/[33]
M30
