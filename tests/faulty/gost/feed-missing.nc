%012 LF
N1 (нет подачи) LF
N2 G01 X10. LF
N3 M02 LF
