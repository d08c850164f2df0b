(tool beyond 255)
T256 M6
M2
