(DPRNT: no format behind the variable)
FOPEN2 <x.txt>
DPRNT[X#100]
FCLOS
M30
