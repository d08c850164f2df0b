O100 sub
G1 F100 X#1
O100 endsub
O100 call [5]
O101 if [1 GT 2]
O102 while [0]
O101 endif
O102 endwhile
O103 break
O100 call [1
O104 repeat [2]
G1 X1
O104 endrepeat
O105 endsub
O106 call
O107 foo
M2
