(nothing behind the sign =)
#1=
M2
