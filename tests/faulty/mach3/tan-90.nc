(tangent of 90 degrees)
G0 XTAN[90]
M2
