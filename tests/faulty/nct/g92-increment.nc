(operator I with G92)
G92 XI10
M30
