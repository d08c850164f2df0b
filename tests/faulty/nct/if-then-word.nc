(a word after THEN)
IF[1 EQ 1] THEN X5
M30
