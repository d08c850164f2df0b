(** of other controls)
#1=2**3
M30
