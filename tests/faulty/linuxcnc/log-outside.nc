G21 G90
(LOGOPEN,../log.txt)
(LOG,nothing is open)
M2
