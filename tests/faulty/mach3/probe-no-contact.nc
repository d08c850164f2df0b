(no contact)
F100
G31 Z-10
M2
