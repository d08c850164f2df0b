(DO without a number)
DO
M30
