(AX[9]: the channel has no axis 9)
G0 AX[9]=10
M30
