%
(step 60 x 40 x 20, zero in the middle of the top; the part that is wanted: step.stl)
N10 G21 G17 G90 G40 G49 G80
N20 T1 M6
N30 S3500 M3
N40 G0 X40 Y-26 Z5
N50 Z-4 M8
(roughing, two levels)
N60 M98 P100 L1
N70 G0 Z5
N80 X40 Y-26
N90 Z-7.8
N100 M98 P100 L1
(the floor: one line is 0.2 deeper than wanted)
N110 G0 Z5
N120 X40 Y-26
N130 Z-8
N140 G1 X15.2 F600
N150 Y26
N160 G0 X23
N170 G1 Z-8.2 F200
N180 Y-26 F600
N190 G0 Z5
(the wall: its end is left standing)
N200 X15 Y-26
N210 Z-8
N220 G1 Y12
N230 G0 Z50 M9
N240 M30
O100 (one level, 0.2 from the wall)
N310 G1 X30.2 F900
N320 Y26
N330 X22.2
N340 Y-26
N350 X15.2
N360 Y26
N370 M99
%
