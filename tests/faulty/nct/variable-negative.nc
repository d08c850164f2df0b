(a negative number)
#1=-5
#[#1]=3
M30
