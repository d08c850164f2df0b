(AND of two conditions, each in brackets)
IF[[#1 EQ 1] AND [#2 EQ 2]] GOTO10
N10 M30
