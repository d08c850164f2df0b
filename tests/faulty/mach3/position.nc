(a coordinate beyond ten kilometres)
G0 X20000000
G91
G0 X9000000
G0 X9000000
M2
