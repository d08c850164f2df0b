(a path out of the program memory)
FOPEN2 <..\..\x.txt>
M30
