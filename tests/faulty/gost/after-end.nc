%012 LF
N1 (за M02 УП не читается) LF
N2 G00 X1. LF
N3 M02 LF
N4 G77 X1. X2. @ LF
