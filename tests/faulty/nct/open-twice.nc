(two files at a time)
FOPEN2 <x.txt>
FOPEN2 <y.txt>
FCLOS
M30
