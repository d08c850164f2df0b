(IF[…] and nothing)
IF[#1 EQ 5]
M30
