(five M words)
M3 M7 M48 M6 T1 M101
M2
