%012 LF
N1 (русская Х) LF
N2 G00 Х1. LF
N3 М02 LF
