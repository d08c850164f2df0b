(BPRNT: one digit, the decimals)
FOPEN2 <x.txt>
BPRNT[X#100[53]]
FCLOS
M30
