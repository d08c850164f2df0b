(T takes eight digits)
T100000000
M30
