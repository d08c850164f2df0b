(G0TO with the digit 0)
G0 X5
G0TO10
N10 M30
