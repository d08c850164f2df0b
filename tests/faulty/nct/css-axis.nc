(G96 P9: the channel has no axis 9)
G96 S100 P9 M3
M30
