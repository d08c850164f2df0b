(there are 16 spindles)
S500 P17
M30
