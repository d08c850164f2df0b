(/ in place of \)
M98 <subs/one.nc>
M30
