(the condition is no condition)
WHILE[] DO1
END1
M30
