(DPRNT: a character that cannot be sent)
FOPEN2 <x.txt>
DPRNT[X$#100[53]]
FCLOS
M30
