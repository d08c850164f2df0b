(beyond all block numbers)
#1=999999999
GOTO#1
M30
