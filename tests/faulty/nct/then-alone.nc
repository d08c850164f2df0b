(THEN without IF)
THEN#1=5
M30
