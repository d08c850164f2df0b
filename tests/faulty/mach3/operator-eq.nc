(EQ is not in Mach3 proper)
#1=[1 EQ 2]
M2
