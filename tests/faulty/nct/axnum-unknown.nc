(AXNUM of an axis that is not there)
#1=AXNUM[Q]
M30
