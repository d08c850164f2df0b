(> is missing in FOPEN)
FOPEN2 <x.txt
M30
