(G66 takes no file name)
G66 <sub.nc> A1
G67
M30
