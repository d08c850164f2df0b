(/ in a path)
FOPEN2 <a/x.txt>
M30
