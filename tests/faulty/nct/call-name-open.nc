(> is missing)
M98 <sub.nc
M30
