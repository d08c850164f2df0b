(braces in place of brackets)
#1={2+3}
M30
