%
O0100 (a program)
 n10 g0 x1 (c)
G90 G17 G40 G49 G67 G94
#100=2.5 (a number)
N20 G01 Y[1+#100] F100
/N30 X2

/8 Z#1 X#2 Y#3 (all empty: no motion)
G#4 X5
IF[#1 EQ #0] THEN #2=1
G65 P10 A#1 B[-2*3]
T1 M6
G28 G91 Z0
M30
O10
M99
%
