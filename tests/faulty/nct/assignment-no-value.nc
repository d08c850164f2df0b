(nothing behind =)
#1=
M30
