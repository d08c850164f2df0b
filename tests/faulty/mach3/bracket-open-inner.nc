(inner bracket not closed)
#1=[2*[3+4]
M2
