# Slip velocity v*(s) for four tractions Q* (the paper's Fig. 3).
name = 'slip'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

quantity = 'v'
parameter = 'traction'; symbol = 'Q*'; values = '0.2 0.4 0.5 0.59'; order = '1 2 3 4'
eval range(-1, 1, 0, 0.8)
eval axes('s', 'v*')
eval key(0.05, 0.95)
set xtics 0.5
set ytics 0.2
eval label_family
eval draw_family
