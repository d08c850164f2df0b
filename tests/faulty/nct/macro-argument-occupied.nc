(E: its variable holds the second J)
G65 A2.12 B3.213 J36.9 J-12 E129.73 P10
M30
O10
M99
