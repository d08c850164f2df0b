(FOPEN1: the file is there)
FOPEN1 <open-exists-name.expect>
M30
