(no spindle is named S3)
S3=500 M3
M30
