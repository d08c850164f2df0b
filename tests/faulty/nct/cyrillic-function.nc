(Cyrillic С in COS)
#1=СOS[30]
M30
