(no function FOO)
G0 X[FOO[2]]
M2
