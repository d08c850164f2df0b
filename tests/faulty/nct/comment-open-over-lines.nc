(a comment over lines, then one that is never closed)
(one
two) G0 X10
G0 Y5 (three
M30
