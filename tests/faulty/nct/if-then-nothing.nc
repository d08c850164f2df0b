(THEN and nothing)
IF[1 EQ 1] THEN
M30
