(there is no #34)
#34=1
M30
