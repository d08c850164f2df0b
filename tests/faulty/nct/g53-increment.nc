(operator I with G53)
G53 XI10
M30
