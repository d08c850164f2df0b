%012 LF
N1 (знак у подачи) LF
N2 G00 X1. F-5 LF
N3 M02 LF
