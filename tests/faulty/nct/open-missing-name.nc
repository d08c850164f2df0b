(FOPEN5: no such file)
FOPEN5 <no-such.txt>
M30
