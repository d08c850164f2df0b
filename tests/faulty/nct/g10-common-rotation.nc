(the common offset has no rotation)
G10 L2 P0 X10 I30
M30
