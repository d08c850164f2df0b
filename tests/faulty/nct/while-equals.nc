(an assignment in WHILE)
WHILE[#1=5] DO1
END1
M30
