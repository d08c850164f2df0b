(the bit is missing)
#1=PRM[107]/[4]
M30
