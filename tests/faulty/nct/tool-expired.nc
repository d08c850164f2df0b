(all tools of the number are expired)
T5 M6
M30
