(two comments over lines in a block, and a fault behind them)
G0 X10 (one
two) Y1 (three
four) Z2 Q5
M30
