(no such file)
M98 <no-such.nc>
M30
