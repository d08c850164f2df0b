(no fault: blank lines, percent lines, lower case, comments)
%

 g0 x1 (c) ; d
N10 g1 y[1+1]f100
/N20 x2 // slashes
 M2 
%
