(the skip sign inside a block)
G0 X10 /2 Y5
M30
