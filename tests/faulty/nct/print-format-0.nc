(DPRNT: no digits)
FOPEN2 <x.txt>
DPRNT[X#100[00]]
FCLOS
M30
