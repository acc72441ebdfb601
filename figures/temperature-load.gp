# Surface temperature T*(s) at Pe = 1000 for four tractions Q* (the paper's Fig. 5).
name = 'temperature-load'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

quantity = 'T'
parameter = 'traction'; symbol = 'Q*'; values = '0.2 0.4 0.5 0.59'; order = '1 2 3 4'
eval range(-1, 3, 0, 0.008)
eval axes('s', 'T*')
eval key(0.53, 0.95)
set xtics 1
set ytics 0.002
eval label_family
eval draw_family
