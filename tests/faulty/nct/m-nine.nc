(nine M codes in a block)
M21 M22 M23 M24 M25 M26 M27 M28 M29
M30
