(LT is not in Mach3 proper)
G0 X[2 LT 3]
M2
